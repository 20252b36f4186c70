// SPDX-License-Identifier: MIT
#include "techniques/shadow/volume-clamped/shadowed_casters.h"

#include <algorithm>
#include <cmath>

namespace ombrage {

namespace {

/// Of a box's extent, by which it is taken larger: positions are rounded.
constexpr float kMargin = 1e-3f;
/// Of a box's distance from the light: nearer than this an edge is cut off before it is projected.
constexpr float kNearest = 1e-4f;

/// The picture that a light has of a box: a plane across the axis, at distance 1 under a point light.
class Outline {
public:
    Outline(const LightRays& rays, const BoxSight& box, const glm::vec3& lower, const glm::vec3& upper)
        : m_rays(rays), m_axis(box.axis), m_nearest_m(box.nearest_m * kNearest) {
        const glm::vec3 aside = std::abs(m_axis.x) < 0.6f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
        m_right = glm::normalize(glm::cross(m_axis, aside));
        m_up = glm::cross(m_right, m_axis);
        for (int c = 0; c < 8; ++c) {
            const glm::vec2 p =
                projected({c & 1 ? upper.x : lower.x, c & 2 ? upper.y : lower.y, c & 4 ? upper.z : lower.z});
            m_lower = glm::min(m_lower, p);
            m_upper = glm::max(m_upper, p);
        }
        const glm::vec2 margin = (m_upper - m_lower) * kMargin + 1e-6f;
        m_lower -= margin;
        m_upper += margin;
    }

    /// Whether an edge may pass before or behind the box, seen from the light.
    bool meets(glm::vec3 a, glm::vec3 b) const {
        if (!m_rays.sun && !cut(a, b)) return false;
        const glm::vec2 p = projected(a), q = projected(b);
        if (glm::any(glm::lessThan(glm::max(p, q), m_lower)) || glm::any(glm::greaterThan(glm::min(p, q), m_upper)))
            return false;
        // The rectangle lies on one side of the edge's line.
        const glm::vec2 normal(p.y - q.y, q.x - p.x), middle = (m_lower + m_upper) * 0.5f;
        const float reach = glm::dot(glm::abs(normal), (m_upper - m_lower) * 0.5f);
        return std::abs(glm::dot(normal, middle - p)) <= reach;
    }

private:
    glm::vec2 projected(const glm::vec3& p) const {
        if (m_rays.sun) return {glm::dot(p, m_right), glm::dot(p, m_up)};
        const glm::vec3 d = p - m_rays.position;
        return glm::vec2(glm::dot(d, m_right), glm::dot(d, m_up)) / glm::dot(d, m_axis);
    }

    /// Leaves of an edge what lies before the light; false: nothing.
    bool cut(glm::vec3& a, glm::vec3& b) const {
        float da = m_rays.along(m_axis, a) - m_nearest_m, db = m_rays.along(m_axis, b) - m_nearest_m;
        if (da <= 0 && db <= 0) return false;
        if (da > 0 && db > 0) return true;
        (da <= 0 ? a : b) = glm::mix(a, b, da / (da - db));
        return true;
    }

    const LightRays& m_rays;
    glm::vec3 m_axis, m_right, m_up;
    float m_nearest_m;
    glm::vec2 m_lower{INFINITY}, m_upper{-INFINITY};
};

/// How far the box's farthest corner lies along an axis.
float farthestAlong(const LightRays& rays, const glm::vec3& axis, const glm::vec3& lower, const glm::vec3& upper) {
    const glm::vec3 corner(axis.x > 0 ? upper.x : lower.x, axis.y > 0 ? upper.y : lower.y,
                           axis.z > 0 ? upper.z : lower.z);
    return rays.along(axis, corner);
}

}  // namespace

VolumeChoice shadowedCasters(FrameContext& frame, const LightFrame& light, const ShadowVolumes& volumes,
                             const LightRays& rays) {
    GpuScene& scene = *frame.gpuScene;
    const FlatScene& flat = scene.flat();
    const VolumeChoice& casters = volumes.casters();
    std::vector<std::optional<std::vector<glm::uvec2>>> silhouettes(casters.size());
    VolumeChoice shadowed(casters.size());
    for (std::size_t i = 0; i < casters.size(); ++i) {
        const auto& [lower, upper] = scene.instanceBounds(i);
        const std::optional<BoxSight> box = casters[i] ? rays.sight(lower, upper) : std::nullopt;
        if (!box) continue;
        const glm::vec3 middle = (lower + upper) * 0.5f;
        const Outline outline(rays, *box, lower, upper);
        for (std::size_t o = 0; o < casters.size() && !shadowed[i]; ++o) {
            // One that ends before this one begins,
            const auto& [otherLower, otherUpper] = scene.instanceBounds(o);
            if (o == i || !casters[o] || !scene.isOnTheWay(o, middle, light.toward())) continue;
            if (farthestAlong(rays, box->axis, otherLower, otherUpper) >= box->nearest_m) continue;
            // whose silhouette passes this one by, so that it covers either all of it or nothing:
            if (!silhouettes[o]) silhouettes[o] = volumes.silhouette(scene, o);
            const std::size_t first = flat.instances[o].firstVertex;
            if (std::any_of(silhouettes[o]->begin(), silhouettes[o]->end(), [&](const glm::uvec2& edge) {
                    return outline.meets(flat.positions[first + edge.x], flat.positions[first + edge.y]);
                }))
                continue;
            // a ray decides.
            VolumeChoice alone(casters.size());
            alone[o] = true;
            shadowed[i] = volumes.around(frame, light, middle, alone) > 0;
        }
    }
    return shadowed;
}

}  // namespace ombrage
