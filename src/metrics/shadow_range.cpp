// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <ombrage/metrics.h>

namespace ombrage {

std::vector<bool> inRange(const ShadowRange& range, const std::vector<glm::dvec3>& positions_world,
                          const Camera& camera) {
    std::vector<bool> covered(positions_world.size(), true);
    const glm::dvec3 axis = glm::normalize(camera.target - camera.position);
    for (std::size_t i = 0; i < covered.size(); ++i) {
        const glm::dvec3& p = positions_world[i];
        const bool isSeen =
            std::any_of(range.clipFromWorld.begin(), range.clipFromWorld.end(), [&](const glm::dmat4& m) {
                const glm::dvec4 c = m * glm::dvec4(p, 1.0);
                return c.w > 0 && std::abs(c.x) <= c.w && std::abs(c.y) <= c.w;
            });
        covered[i] = (range.clipFromWorld.empty() || isSeen) && glm::dot(p - camera.position, axis) <= range.farthest_m;
    }
    return covered;
}

}  // namespace ombrage
