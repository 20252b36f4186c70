// SPDX-License-Identifier: MIT
#pragma once

#include "reference/reference_impl.h"
#include "reference/sample_sets.h"
#include "scene/camera_view.h"

namespace ombrage {

/// Which directions are asked for.
enum class Spread { Cosine, Hemisphere, Sphere };

/// Unit directions about `n`, one for each sample.
void directions(const glm::dvec3& n, Spread spread, const PolarSamples& samples, RayBundle& bundle);

/// What is asked of ambient visibility.
struct AoQuestion {
    TruthKind kind = TruthKind::T1;
    double radius_m = 0;                     ///< +inf where nothing bounds the rays
    const AoIntegrand* integrand = nullptr;  ///< of Own
    double sceneDiagonal_m = 0;              ///< of Own
    const CameraView* view = nullptr;        ///< of Own
};

/// Answers one question at many points. Safe to use from several threads.
class AoEstimator {
public:
    /// All must outlive this.
    AoEstimator(const RayScene& rays, const FlatScene& flat, const AoQuestion& question, const SampleSets& sets)
        : m_rays(rays), m_flat(flat), m_question(question), m_sets(sets) {}

    /// Mean and standard error.
    Reference::Estimate at(const SurfacePoint& point, std::uint32_t seed) const;

private:
    double openShare(const SurfacePoint& point, const RayOrigin& origin, int scrambling, std::uint32_t seed) const;
    double fadedShare(const SurfacePoint& point, int scrambling, std::uint32_t seed) const;
    double freeVolume(const SurfacePoint& point, int scrambling, std::uint32_t seed) const;
    double ownMean(const SurfacePoint& point, int scrambling, std::uint32_t seed) const;

    const RayScene& m_rays;
    const FlatScene& m_flat;
    const AoQuestion& m_question;
    const SampleSets& m_sets;
};

}  // namespace ombrage
