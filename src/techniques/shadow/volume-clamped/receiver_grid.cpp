// SPDX-License-Identifier: MIT
#include "techniques/shadow/volume-clamped/receiver_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace ombrage {

namespace {

/// Cells beyond a box's own that count as its own: positions are rounded on their way to the grid.
constexpr float kCellMargin = 0.01f;
constexpr float kAngleMargin_rad = 1e-3f;
/// Boxes that fill more of a point light's view have no axis to measure along.
constexpr float kWidestCone_rad = 1.3f;

std::array<glm::vec3, 8> cornersOf(const glm::vec3& lower, const glm::vec3& upper) {
    std::array<glm::vec3, 8> corners;
    for (int c = 0; c < 8; ++c)
        corners[std::size_t(c)] = {c & 1 ? upper.x : lower.x, c & 2 ? upper.y : lower.y, c & 4 ? upper.z : lower.z};
    return corners;
}

float angleBetween(const glm::vec3& a, const glm::vec3& b) {
    return std::acos(std::clamp(glm::dot(a, b), -1.0f, 1.0f));
}

/// The direction of a point of a face of the cube, as shadow/volume-clamped/receiver_grid.comp has them.
glm::vec3 directionOn(int face, float u, float v) {
    const int axis = face / 2;
    glm::vec3 d;
    d[axis] = face % 2 == 0 ? 1.0f : -1.0f;
    d[(axis + 1) % 3] = u * 2 - 1;
    d[(axis + 2) % 3] = v * 2 - 1;
    return glm::normalize(d);
}

}  // namespace

LightRays LightRays::ofSun(const glm::vec3& direction, const glm::vec3& right, const glm::vec3& lower,
                           const glm::vec3& upper) {
    LightRays rays;
    rays.sun = true;
    rays.direction = direction;
    rays.right = right;
    rays.up = glm::cross(right, direction);
    glm::vec2 from(INFINITY), to(-INFINITY);
    rays.start_m = INFINITY;
    for (const glm::vec3& p : cornersOf(lower, upper)) {
        const glm::vec2 across(glm::dot(p, rays.right), glm::dot(p, rays.up));
        from = glm::min(from, across);
        to = glm::max(to, across);
        rays.start_m = std::min(rays.start_m, glm::dot(p, direction));
    }
    rays.corner = from;
    rays.size = glm::max(to - from, glm::vec2(1e-6f));
    return rays;
}

LightRays LightRays::from(const glm::vec3& position) {
    LightRays rays;
    rays.position = position;
    return rays;
}

float LightRays::along(const glm::vec3& axis, const glm::vec3& p) const {
    return sun ? glm::dot(p, axis) - start_m : glm::dot(p - position, axis);
}

glm::vec4 LightRays::plane(const glm::vec3& axis, float distance_m) const {
    return {axis, -(distance_m + (sun ? start_m : glm::dot(position, axis)))};
}

std::optional<BoxSight> LightRays::sight(const glm::vec3& lower, const glm::vec3& upper) const {
    BoxSight box;
    box.nearest_m = INFINITY;
    box.farthest_m = -INFINITY;
    const std::array<glm::vec3, 8> corners = cornersOf(lower, upper);
    const glm::vec3 middle = (lower + upper) * 0.5f;
    if (!sun && glm::distance(middle, position) <= 1e-6f) return std::nullopt;
    box.axis = sun ? direction : glm::normalize(middle - position);
    box.lower = glm::vec2(INFINITY);
    box.upper = glm::vec2(-INFINITY);
    for (const glm::vec3& p : corners) {
        const float distance_m = along(box.axis, p);
        box.nearest_m = std::min(box.nearest_m, distance_m);
        box.farthest_m = std::max(box.farthest_m, distance_m);
        if (sun) {
            const glm::vec2 across(glm::dot(p, right), glm::dot(p, up));
            box.lower = glm::min(box.lower, across);
            box.upper = glm::max(box.upper, across);
        } else {
            box.halfAngle_rad = std::max(box.halfAngle_rad, angleBetween(glm::normalize(p - position), box.axis));
        }
    }
    box.closest_m = sun ? box.nearest_m : glm::distance(position, glm::clamp(position, lower, upper));
    if (!sun && (box.nearest_m <= 0 || box.closest_m <= 0 || !(box.halfAngle_rad <= kWidestCone_rad)))
        return std::nullopt;
    return box;
}

ReceiverGrid::ReceiverGrid(const LightRays& rays, int cellsAcross, std::vector<glm::uvec2> cells)
    : m_rays(rays), m_cellsAcross(cellsAcross), m_cells(std::move(cells)) {
    if (rays.sun) return;
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < cellsAcross; ++y)
            for (int x = 0; x < cellsAcross; ++x) {
                const auto at = [&](float dx, float dy) {
                    return directionOn(face, (float(x) + dx) / float(cellsAcross),
                                       (float(y) + dy) / float(cellsAcross));
                };
                Cone cone{at(0.5f, 0.5f), 0.0f};
                for (const glm::vec3& corner : {at(0, 0), at(1, 0), at(0, 1), at(1, 1)})
                    cone.halfAngle_rad = std::max(cone.halfAngle_rad, angleBetween(cone.axis, corner));
                cone.halfAngle_rad += kAngleMargin_rad;
                m_cones.push_back(cone);
            }
}

template <typename F>
void ReceiverGrid::forCellsOf(const BoxSight& box, F&& visit) const {
    if (m_rays.sun) {
        const auto cell = [&](float p, int k, float margin) {
            const float at = (p - m_rays.corner[k]) / m_rays.size[k] * float(m_cellsAcross) + margin;
            return int(std::clamp(std::floor(at), 0.0f, float(m_cellsAcross - 1)));
        };
        for (int y = cell(box.lower.y, 1, -kCellMargin); y <= cell(box.upper.y, 1, kCellMargin); ++y)
            for (int x = cell(box.lower.x, 0, -kCellMargin); x <= cell(box.upper.x, 0, kCellMargin); ++x)
                visit(std::size_t(y * m_cellsAcross + x), 0.0f, 0.0f);
        return;
    }
    for (std::size_t c = 0; c < m_cells.size(); ++c) {
        if (m_cells[c].x == kEmpty) continue;
        const float between = angleBetween(m_cones[c].axis, box.axis), reach = m_cones[c].halfAngle_rad;
        if (between <= box.halfAngle_rad + reach) visit(c, std::max(0.0f, between - reach), between + reach);
    }
}

std::optional<ReceiverGrid::Range> ReceiverGrid::receiversOf(const BoxSight& box) const {
    Range range{INFINITY, -INFINITY};
    forCellsOf(box, [&](std::size_t cell, float least_rad, float most_rad) {
        if (m_cells[cell].x == kEmpty) return;
        // A distance from the light is this much or that along the axis, by the angle between them.
        const float shortest = std::cos(std::min(most_rad, 1.5707963f)), longest = std::cos(least_rad);
        range.nearest_m = std::min(range.nearest_m, std::bit_cast<float>(m_cells[cell].x) * shortest);
        range.farthest_m = std::max(range.farthest_m, std::bit_cast<float>(m_cells[cell].y) * longest);
    });
    if (range.farthest_m < range.nearest_m) return std::nullopt;
    return range;
}

float ReceiverGrid::farthestOf(const BoxSight& box) const {
    float farthest_m = -INFINITY;
    forCellsOf(box, [&](std::size_t cell, float, float) {
        if (m_cells[cell].x != kEmpty) farthest_m = std::max(farthest_m, std::bit_cast<float>(m_cells[cell].y));
    });
    return farthest_m;
}

}  // namespace ombrage
