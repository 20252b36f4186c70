// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include "techniques/omni_seams.h"

namespace ombrage::test {
namespace {

/// The angle to the plane between the two faces that a direction is nearest to. The tetrahedron stands on one corner.
double toSeam_rad(const glm::dvec3& l) {
    const double c = std::sqrt(8.0) / 3, h = std::sqrt(0.75) * c;
    const std::array<glm::dvec3, 4> corners{
        glm::dvec3(0, -1, 0), {c, 1.0 / 3, 0}, {-c / 2, 1.0 / 3, h}, {-c / 2, 1.0 / 3, -h}};
    std::array<double, 4> along;
    for (std::size_t i = 0; i < 4; ++i) along[i] = -glm::dot(l, corners[i]);
    std::sort(along.begin(), along.end());
    // The normals of two faces differ by the edge between their corners, of length sqrt(8/3).
    return std::asin((along[3] - along[2]) / std::sqrt(8.0 / 3));
}

TEST(OmniTetrahedron, MeetsTheCubeAtEqualTexelsAndHidesItsSeams) {
    // 2 x 1774^2 is 6 x 1024^2. At the middle of a seam, 54.7 degrees off the axis, a texel is 2.45 * 2 / 1774 at unit
    // depth, seen from sqrt(3) away at that angle: a third of it.
    expectOmniBudget("shadow/omni-tetrahedron:resolution=1774", toSeam_rad, 2 * 2.45 * 2 / 1774 / 3);
}

}  // namespace
}  // namespace ombrage::test
