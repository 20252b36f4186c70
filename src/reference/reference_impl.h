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

/// The receiver of pixel `index`, its position from the barycentrics in double, kept `inset_m` away from its triangle's
/// edges: a point on the very crease of two walls has no answer, the limit from its own side has.
SurfacePoint surfacePoint(const FlatScene& flat, const Receivers& receivers, std::size_t index, double inset_m);

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
