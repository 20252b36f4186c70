// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "scene/flat_scene.h"

namespace ombrage {

/// A ray in the space moved by FlatScene::origin.
struct Ray {
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0, 0, -1};  ///< unit
    double length_m = std::numeric_limits<double>::infinity();
    std::uint32_t ownTriangle = 0xffffffffu;       ///< never hit: the one that the origin lies on
    const std::vector<bool>* instances = nullptr;  ///< per instance, whether the ray sees it; null: all are seen
};

/// Where many rays start: what they have in common is looked up once.
struct RayOrigin {
    glm::dvec3 position{0.0};
    glm::dvec3 normal{0, 1, 0};  ///< of the triangle that it lies on
    std::uint32_t ownTriangle = 0xffffffffu;
    const std::vector<bool>* instances = nullptr;  ///< as in Ray
    bool alone = false;  ///< no other triangle is so near that hits must be looked at twice, and all instances are seen
};

/// Rays from one origin, in single precision as they are traced.
struct RayBundle {
    static constexpr int kSize = 16;
    alignas(64) std::array<float, kSize> x{}, y{}, z{};  ///< unit directions
    alignas(64) std::array<float, kSize> length_m{};
};

struct RayHit {
    std::uint32_t triangle = 0;  ///< global triangle id
    double u = 0, v = 0;         ///< weights of the second and third vertex
    double distance_m = 0;
};

struct RayCrossing {
    double distance_m = 0;
    bool fromFront = true;  ///< the ray meets the side that the triangle's winding shows
};

/// The triangles of a FlatScene in Embree, the one user of it. Robust mode, no offsets: the ray's own triangle is left
/// out by identity, and planes that hold the origin are told in double precision. Texels below the cut-off of a
/// AlphaMode::Mask material are holes. Immutable; safe to use from several threads.
class RayScene {
public:
    /// Both must outlive this. @throws Error(Environment) when Embree cannot start or has no memory.
    RayScene(const Scene& scene, const FlatScene& flat);
    ~RayScene();
    RayScene(const RayScene&) = delete;
    RayScene& operator=(const RayScene&) = delete;

    bool occluded(const Ray& ray) const;

    /// The same for up to RayBundle::kSize rays that start and end near each other, one bit each.
    std::uint32_t occluded(const Ray* rays, int count) const;

    std::optional<RayHit> nearest(const Ray& ray) const;

    /// Looks around the point once. `instances` as in Ray.
    RayOrigin startAt(const glm::dvec3& position, const glm::dvec3& normal, std::uint32_t ownTriangle,
                      const std::vector<bool>* instances) const;

    /// One bit for each ray of the bundle: whether it is blocked. 0 where the bit in `wanted` is 0.
    std::uint32_t occluded(const RayOrigin& origin, const RayBundle& bundle, std::uint32_t wanted) const;

    /// Every surface that the ray meets, nearest first.
    void crossings(const Ray& ray, std::vector<RayCrossing>& found) const;

    /// Length of a ray that ends just before a light so far away; a sun stays infinitely far.
    double lengthTo_m(double distance_m) const;

    /// Rounding error of a position in this space times a few: how near to the light a hit may count as the light
    /// itself.
    double positionError_m(double distance_m) const;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

/// Whether the point of a triangle is a hole: alpha times the nearest texel's opacity, repeat wrapping, is below the
/// cut-off.
bool isHole(const Scene& scene, const Material& material, glm::vec2 uv);

}  // namespace ombrage
