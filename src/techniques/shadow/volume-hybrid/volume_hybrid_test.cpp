// SPDX-License-Identifier: MIT
// What the hybrid is for: nearly all of the picture is decided by the map.
#include <gtest/gtest.h>

#include "techniques/technique_case.h"

namespace ombrage::test {
namespace {

TEST(VolumeHybrid, LeavesLittleMoreThanEdgesToTheVolumes) {
    Bench& bench = Bench::of("gap");
    RenderSettings settings;
    settings.width = kWidth;
    settings.height = kHeight;
    settings.countSavings = true;
    settings.shadow = parsePipeline(Family::Shadow, "shadow/volume-hybrid");
    const RenderResult result = renderScene(bench.scene(), settings);
    // The edges of one shadow are some 300 pixels long; the shadow itself covers 15,000.
    EXPECT_GT(result.counters.at("pixels left to volumes"), 50);
    EXPECT_LT(result.counters.at("pixels left to volumes"), 1000);
    EXPECT_GT(result.counters.at("fill saved"), 0.98 * result.counters.at("fill of z-fail"));
}

}  // namespace
}  // namespace ombrage::test
