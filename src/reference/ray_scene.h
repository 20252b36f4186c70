// SPDX-License-Identifier: MIT
#pragma once

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

struct RayHit {
    std::uint32_t triangle = 0;  ///< global triangle id
    double u = 0, v = 0;         ///< weights of the second and third vertex
    double distance_m = 0;
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
    std::optional<RayHit> nearest(const Ray& ray) const;

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
