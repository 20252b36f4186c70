// SPDX-License-Identifier: MIT
#include "techniques/shared/eye_contact.h"

#include <cmath>

#include "render/frame_context.h"

namespace ombrage {

bool touchesEye(const FrameContext& frame, std::size_t instance) {
    const glm::vec3& eye = frame.view.eye;
    const float reach_m = frame.view.nearReach_m();
    if (!frame.gpuScene->isWithin(instance, eye, reach_m)) return false;
    const FlatScene& flat = frame.gpuScene->flat();
    const FlatInstance& range = flat.instances[instance];
    for (std::uint32_t t = 0; t < range.triangleCount; ++t) {
        const glm::uvec3& v = flat.triangles[range.firstTriangle + t];
        const glm::vec3 &a = flat.positions[v.x], &b = flat.positions[v.y], &c = flat.positions[v.z];
        // In its bounds, and not far from its plane.
        const glm::vec3 lower = glm::min(a, glm::min(b, c)) - reach_m, upper = glm::max(a, glm::max(b, c)) + reach_m;
        if (glm::any(glm::lessThan(eye, lower)) || glm::any(glm::greaterThan(eye, upper))) continue;
        const glm::vec3 normal = glm::cross(b - a, c - a);
        if (std::abs(glm::dot(normal, eye - a)) <= reach_m * glm::length(normal)) return true;
    }
    return false;
}

}  // namespace ombrage
