// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "reference/reference_impl.h"

namespace ombrage {

/// Whether a point sees that part of a light.
bool isSeen(const RayScene& rays, const SurfacePoint& point, const LightSample& s, const std::vector<bool>* casters);

/// What masked pixels show: dark where the light cannot reach, lit where nothing is asked.
inline double maskedVisibility(Mask mask) {
    return mask == Mask::BelowHorizon || mask == Mask::OutOfRange ? 0.0 : 1.0;
}

/// Fills the truth of one light row by row. The truth comes with what a pixel of the sky shows.
class ShadowRows {
public:
    /// Per model of the scene, or one for all, which instances shade it; null: all do.
    using Casters = std::vector<const std::vector<bool>*>;

    ShadowRows(const FlatScene& flat, const RayScene& rays, const Light& light, const LightShape& shape,
               const Receivers& receivers, const Casters& casters, ShadowTruth& truth);

    /// Of a light with a size.
    void soft(int y, const SampleSets& sets, const std::function<std::uint32_t(std::size_t)>& seedOf);

    /// Of a light without: one ray a pixel, traced with its neighbours. A band has kBand rows.
    static constexpr int kBand = 4;
    void hard(int band);

private:
    /// What an instance asks of the light. Models that the light leaves alone are dark; those that receive no shadow
    /// are lit and ask nothing.
    enum class Asks : std::uint8_t { Shadow, Nothing, Excluded };
    struct Aim;
    struct Band;
    struct Queue;

    const std::vector<bool>* castersOf(std::uint32_t instance) const;
    float irradianceOf(const LightSample& centre, const glm::dvec3& shadingNormal) const;
    void hardPixel(std::size_t i, Band& band);
    void enqueue(std::size_t i, const Aim& aim, Queue& queue);
    void flush(Queue& queue);

    const FlatScene& m_flat;
    const RayScene& m_rays;
    const LightShape& m_shape;
    const Receivers& m_receivers;
    const Casters& m_casters;
    ShadowTruth& m_truth;
    std::vector<Asks> m_asks;  ///< per instance
    float m_luminance;         ///< of the light's colour
};

}  // namespace ombrage
