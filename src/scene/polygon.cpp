// SPDX-License-Identifier: MIT
#include "scene/polygon.h"

#include <cmath>

namespace ombrage {

namespace {
/// Twice the area of a triangle, positive counter-clockwise.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The corners seen along the polygon's mean normal (Newell's sum over the edges), counter-clockwise.
std::vector<glm::dvec2> project(std::span<const glm::vec3> corners) {
    glm::dvec3 normal(0.0);
    const glm::dvec3 origin(corners[0]);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 a = glm::dvec3(corners[i]) - origin;
        const glm::dvec3 b = glm::dvec3(corners[(i + 1) % corners.size()]) - origin;
        normal += glm::cross(a, b);
    }
    const glm::dvec3 size = glm::abs(normal);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
    std::vector<glm::dvec2> points;
    points.reserve(corners.size());
    for (const glm::vec3& corner : corners) {
        const glm::dvec3 p = glm::dvec3(corner) - origin;
        const glm::dvec2 q(p[(axis + 1) % 3], p[(axis + 2) % 3]);
        points.push_back(normal[axis] < 0.0 ? glm::dvec2(q.y, q.x) : q);
    }
    return points;
}

/// No other corner of what is left lies in the triangle of an ear.
bool isEmptyEar(const std::vector<glm::dvec2>& points, const std::vector<std::uint32_t>& left, std::size_t at) {
    const std::size_t n = left.size();
    const glm::dvec2 &a = points[left[(at + n - 1) % n]], &b = points[left[at]], &c = points[left[(at + 1) % n]];
    for (std::size_t i = 0; i < n; ++i) {
        const glm::dvec2& p = points[left[i]];
        // Corners that touch the ear's own, as bridges to holes make them, do not count.
        if (p == a || p == b || p == c) continue;
        if (turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0) return false;
    }
    return true;
}
}  // namespace

void triangulate(std::span<const glm::vec3> corners, std::vector<std::uint32_t>& triangles) {
    const std::size_t count = corners.size();
    if (count < 3) return;
    const auto fan = [&](const std::vector<std::uint32_t>& left) {
        for (std::size_t i = 1; i + 1 < left.size(); ++i)
            triangles.insert(triangles.end(), {left[0], left[i], left[i + 1]});
    };
    std::vector<std::uint32_t> left(count);
    for (std::size_t i = 0; i < count; ++i) left[i] = std::uint32_t(i);
    if (count == 3 || count > kMostEars) return fan(left);

    // Convex polygons, nearly all there are, need no search.
    const std::vector<glm::dvec2> points = project(corners);
    bool convex = true;
    for (std::size_t i = 0; i < count; ++i)
        convex = convex && turn(points[i], points[(i + 1) % count], points[(i + 2) % count]) >= 0.0;
    if (convex) return fan(left);

    // Cut off the first corner that turns left and holds no other, until three are left (Meisters 1975). The search
    // goes on behind the last ear; a whole round without one means that the polygon crosses itself.
    std::size_t at = 0, tried = 0;
    while (left.size() > 3 && tried < left.size()) {
        const std::size_t n = left.size();
        at %= n;
        const std::uint32_t before = left[(at + n - 1) % n], here = left[at], after = left[(at + 1) % n];
        if (turn(points[before], points[here], points[after]) > 0.0 && isEmptyEar(points, left, at)) {
            triangles.insert(triangles.end(), {before, here, after});
            left.erase(left.begin() + std::ptrdiff_t(at));
            tried = 0;
        } else {
            ++at;
            ++tried;
        }
    }
    fan(left);
}

}  // namespace ombrage
