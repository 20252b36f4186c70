// SPDX-License-Identifier: MIT
#include "techniques/shared/near_clip.h"

#include <array>
#include <cmath>

namespace ombrage {

namespace {

/// Share by which the rectangle is taken larger, and of the near distance by which it is taken thicker, because
/// positions are rounded on their way to the screen.
constexpr double kMargin = 0.02;

double valueAt(const glm::dvec4& plane, const glm::dvec3& p) {
    return glm::dot(glm::dvec3(plane), p) + plane.w;
}

}  // namespace

NearClipVolume::NearClipVolume(const CameraView& view, const glm::vec4& toward) {
    const glm::dvec3 eye(view.eye), forward(view.forward), right(view.right), up(view.up);
    const double near_m = view.near_m;
    const double halfHeight =
        (1 + kMargin) * (view.orthographic ? 0.5 * view.orthoHeight_m : view.tanHalfFovY * near_m);
    const double halfWidth = halfHeight * view.width / view.height;
    const glm::dvec3 center = eye + forward * near_m;
    const std::array<glm::dvec3, 4> corners{
        center - right * halfWidth - up * halfHeight, center + right * halfWidth - up * halfHeight,
        center + right * halfWidth + up * halfHeight, center - right * halfWidth + up * halfHeight};

    // The near plane, turned to the light. A light within it sees it as a line: then nothing is ruled out.
    const glm::dvec4 light(toward);
    const glm::dvec3 towards = glm::dvec3(light) - center * light.w;
    const double across = glm::dot(forward, towards) / glm::length(towards);
    if (std::abs(across) < 1e-4 || std::abs(glm::dot(forward, towards)) < near_m * kMargin) return;
    const double side = across > 0 ? 1.0 : -1.0;
    m_planes.push_back(glm::dvec4(forward * side, -glm::dot(forward, center) * side + near_m * kMargin));
    if (light.w != 0.0) m_planes.push_back(glm::dvec4(-forward * side, glm::dot(forward, glm::dvec3(light)) * side));

    // A plane through the light and each side of the rectangle, turned to its centre.
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec3 a = corners[i], b = corners[(i + 1) % 4];
        const glm::dvec3 n = glm::normalize(glm::cross(b - a, glm::dvec3(light) - a * light.w));
        const glm::dvec4 plane(n, -glm::dot(n, a));
        m_planes.push_back(valueAt(plane, center) > 0 ? plane : -plane);
    }
}

bool NearClipVolume::touches(const glm::vec3& lower, const glm::vec3& upper) const {
    for (const glm::dvec4& plane : m_planes) {
        // The box's corner that lies farthest inside.
        const glm::dvec3 corner(plane.x > 0 ? upper.x : lower.x, plane.y > 0 ? upper.y : lower.y,
                                plane.z > 0 ? upper.z : lower.z);
        if (valueAt(plane, corner) < 0) return false;
    }
    return true;
}

}  // namespace ombrage
