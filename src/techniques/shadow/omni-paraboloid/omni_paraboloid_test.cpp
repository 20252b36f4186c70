// SPDX-License-Identifier: MIT
#include "techniques/omni_seams.h"

namespace ombrage::test {
namespace {

TEST(OmniParaboloid, MeetsTheCubeAtEqualTexelsAndHidesItsSeam) {
    // 2 x 1774^2 is 6 x 1024^2. The seam is the horizon of the light; a texel there is 2 / 1774 wide.
    expectOmniBudget(
        "shadow/omni-paraboloid:resolution=1774", [](const glm::dvec3& l) { return std::abs(std::asin(l.y)); },
        2 * 2.0 / 1774);
}

}  // namespace
}  // namespace ombrage::test
