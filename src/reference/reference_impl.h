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
/// often share a triangle, so what was worked out of the last few is kept: one object for each thread. Parts of a
/// point cost only what they need.
class SurfacePoints {
public:
    SurfacePoints(const FlatScene& flat, const Receivers& receivers, double inset_m)
        : m_flat(flat), m_receivers(receivers), m_inset_m(inset_m) {}
    SurfacePoints(const SurfacePoints&) = delete;
    SurfacePoints& operator=(const SurfacePoints&) = delete;

    /// The receiver of pixel `index`, which is not sky.
    SurfacePoint at(std::size_t index);

    /// Turns to the receiver of pixel `index`, which is not sky: the one that the others tell of.
    /// @return whether its normal may differ from that of the one before
    bool turnTo(std::size_t index);
    const glm::dvec3& normal() const { return m_normal; }
    glm::dvec3 position();
    glm::dvec3 shadingNormal() const;

private:
    /// What is worked out of a triangle.
    struct Plane {
        std::uint32_t triangle = kNoHit;
        bool knowsLeast = false;
        double doubleArea = 0;
        glm::dvec3 a{0.0}, ab{0.0}, ac{0.0};
        glm::dvec3 normal{0.0};       ///< unit; 0 without area
        glm::dvec3 least{1.0 / 3.0};  ///< least weight of each corner, once it is known
    };
    void fill(Plane& plane, std::uint32_t triangle) const;
    void findLeast(Plane& plane) const;

    const FlatScene& m_flat;
    const Receivers& m_receivers;
    const double m_inset_m;
    std::array<Plane, 16> m_planes;  ///< by the last bits of the triangle's id
    Plane* m_plane = m_planes.data();
    std::size_t m_index = 0;
    glm::vec3 m_stored{0.0f};  ///< the receiver's normal as it is stored
    glm::dvec3 m_normal{0.0};  ///< the same in full precision
};

inline bool SurfacePoints::turnTo(std::size_t index) {
    m_index = index;
    const std::uint32_t triangle = m_receivers.triangle[index];
    const glm::vec3& stored = m_receivers.normal[index];
    if (triangle == m_plane->triangle && stored == m_stored) return false;
    m_plane = &m_planes[triangle % m_planes.size()];
    if (triangle != m_plane->triangle) fill(*m_plane, triangle);

    // The stored normal tells the side; the triangle gives it in full precision.
    m_stored = stored;
    const glm::dvec3 n = m_plane->doubleArea > 0 ? m_plane->normal : glm::dvec3(stored);
    m_normal = glm::dot(n, glm::dvec3(stored)) < 0 ? -n : n;
    return true;
}

inline glm::dvec3 SurfacePoints::position() {
    // In this form a level plane keeps its exact height, which grazing rays along it need.
    if (!m_plane->knowsLeast) findLeast(*m_plane);
    const glm::dvec2 uv(m_receivers.barycentric[m_index]);
    glm::dvec3 w = glm::max(glm::dvec3(1 - uv.x - uv.y, uv.x, uv.y), m_plane->least);
    w /= w.x + w.y + w.z;
    return m_plane->a + m_plane->ab * w.y + m_plane->ac * w.z;
}

inline glm::dvec3 SurfacePoints::shadingNormal() const {
    return glm::normalize(glm::dvec3(m_receivers.shadingNormal[m_index]));
}

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

/// Of all pixels that are not sky, the share that is not valid.
double maskedShareOf(const std::vector<Mask>& mask);

/// Fills meanStandardError over valid pixels and maskedShare over those that are not sky.
void summarise(const std::vector<Mask>& mask, const std::vector<float>& standardError, double& meanStandardError,
               double& maskedShare);

/// @throws Error(Usage) when the receivers' arrays do not belong to their size.
void checkReceivers(const Receivers& receivers);

}  // namespace ombrage
