// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <ombrage/compare.h>

#include "techniques/technique_case.h"

namespace ombrage::test {
namespace {

/// Holes of alpha-tested casters are filled, and what stands behind the caster is seen through them all the same: it is
/// as lit as z-fail, which begins to count behind it, finds it to be. Those that count from the eye enter such a
/// caster's volume unseen.
TEST(ShadowVolume, SeesThroughHolesWhatIsLitBehindThem) {
    const auto visibility = [](const std::string& technique) {
        Bench& bench = Bench::of("fence");
        RenderSettings settings;
        settings.width = 320;
        settings.height = 180;
        settings.shadow = parseTechnique(technique).second;
        return measuredPlane(renderScene(bench.scene(), settings), Family::Shadow);
    };
    const std::vector<float> expected = visibility("shadow/volume-zfail");
    for (const char* technique : {"shadow/volume", "shadow/volume:count=near-clip", "shadow/volume-clamped",
                                  "shadow/volume-tiled", "shadow/volume-blur"}) {
        SCOPED_TRACE(technique);
        EXPECT_EQ(visibility(technique), expected);
    }
}

}  // namespace
}  // namespace ombrage::test
