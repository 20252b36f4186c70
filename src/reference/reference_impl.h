// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <ombrage/reference.h>

#include "core/sobol.h"
#include "reference/light_sampling.h"
#include "reference/ray_scene.h"
#include "scene/flat_scene.h"

namespace ombrage {

/// Samples per pixel where none are asked for.
inline constexpr int kSoftSamples = 1024, kAoSamples = 256;

struct Reference::Impl {
    explicit Impl(const Scene& s) : scene(s), flat(flatten(s)), bounds(s.bounds()), rays(s, flat) {}

    const Scene& scene;
    const FlatScene flat;
    const Bounds bounds;
    const RayScene rays;
};

/// A point to be lit, in the space moved by FlatScene::origin.
struct SurfacePoint {
    glm::dvec3 position{0.0};
    glm::dvec3 normal{0, 1, 0};         ///< n_g, on the side seen
    glm::dvec3 shadingNormal{0, 1, 0};  ///< n_s
    std::uint32_t triangle = kNoHit;    ///< that it lies on
    std::uint32_t instance = kNoHit;
};

/// Turns receivers into points, their positions from the barycentrics in double, kept `inset_m` away from their
/// triangles' edges: a point on the very crease of two walls has no answer, the limit from its own side has. Neighbours
/// often share a triangle, so what was last worked out of one is kept: one object for each thread.
class SurfacePoints {
public:
    SurfacePoints(const FlatScene& flat, const Receivers& receivers, double inset_m)
        : m_flat(flat), m_receivers(receivers), m_inset_m(inset_m) {}

    /// The receiver of pixel `index`, which is not sky.
    SurfacePoint at(std::size_t index);

private:
    void turnTo(std::uint32_t triangle);

    const FlatScene& m_flat;
    const Receivers& m_receivers;
    const double m_inset_m;
    std::uint32_t m_triangle = kNoHit;
    glm::dvec3 m_a{0.0}, m_ab{0.0}, m_ac{0.0};
    glm::dvec3 m_normal{0.0};       ///< unit; 0 without area
    glm::dvec3 m_least{1.0 / 3.0};  ///< least weight of each corner
};

/// Truth of one light at one point.
struct LightTruth {
    Mask mask = Mask::Valid;
    double visibility = 1, standardError = 0;
    double irradianceShare = 1;
    double irradiance = 0;  ///< unshadowed, per unit of colour
};

/// The truth of a light with a size.
/// @param casters per instance, whether it shades this light; null: all do
LightTruth softTruth(const RayScene& rays, const LightShape& light, const SurfacePoint& point,
                     const std::vector<bool>* casters, const SampleSets& sets, std::uint32_t seed);

/// Per instance, whether it shades the light.
std::vector<bool> shadingInstances(const FlatScene& flat, const Light& light);

/// The same for each model of the scene where a model is shaded by itself alone (TruthKind::Self), else once for all.
std::vector<std::vector<bool>> castersByModel(const FlatScene& flat, const Scene& scene, const Light& light,
                                              TruthKind kind);

/// @throws Error(Usage) when the scene has no such light.
const Light& checkedLight(const Scene& scene, int light);

/// The kind of the options, or the first of shadows. @throws Error(Usage) for one that Reference::shadow cannot answer.
TruthKind checkedShadowKind(const ReferenceOptions& options);

/// Samples per scrambling so that all of them are at least `total`, or `fallback` where that is 0.
/// @throws Error(Usage) below 0.
int samplesPerScrambling(int total, int fallback);

/// Mean over the scramblings' means, and its standard error.
Reference::Estimate combine(const std::array<double, kScramblings>& means);

/// Seed of one point's samples. Every light and the ambient occlusion have their own stream.
std::uint32_t pointSeed(std::uint64_t seed, std::uint32_t stream, std::uint32_t index);

/// Fills meanStandardError over valid pixels and maskedShare over those that are not sky.
void summarise(const std::vector<Mask>& mask, const std::vector<float>& standardError, double& meanStandardError,
               double& maskedShare);

/// @throws Error(Usage) when the receivers' arrays do not belong to their size.
void checkReceivers(const Receivers& receivers);

}  // namespace ombrage
