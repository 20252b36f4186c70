// SPDX-License-Identifier: MIT
// Tiles are a way to do less, so they must answer as shadow/volume does, pixel by pixel.
#include <cmath>

#include <gtest/gtest.h>
#include <ombrage/compare.h>
#include <ombrage/reference.h>

#include "techniques/technique_case.h"

namespace ombrage::test {
namespace {

RenderResult shadowOf(const std::string& scene, const std::string& technique, int width, int height) {
    Bench& bench = Bench::of(scene);
    RenderSettings settings;
    settings.countSavings = true;
    settings.width = width;
    settings.height = height;
    settings.light = bench.scene().lights.front().name;
    settings.shadow = parseTechnique(technique).second;
    return renderScene(bench.scene(), settings);
}

/// Pictures whose sides are and are not multiples of 8: tiles then reach beyond the right and the upper border.
TEST(VolumeTiled, AnswersAsShadowVolumeDoesWhateverThePicturesSize) {
    for (const std::string scene : {"in-shadow", "bicycle", "two-casters"})
        for (const glm::ivec2 size : {glm::ivec2(320, 184), glm::ivec2(323, 181), glm::ivec2(9, 7)}) {
            const RenderResult whole = shadowOf(scene, "shadow/volume", size.x, size.y);
            const RenderResult tiled = shadowOf(scene, "shadow/volume-tiled", size.x, size.y);
            const std::vector<float> expected = measuredPlane(whole, Family::Shadow),
                                     found = measuredPlane(tiled, Family::Shadow);
            ASSERT_EQ(expected.size(), found.size());
            std::size_t different = 0;
            for (std::size_t i = 0; i < found.size(); ++i) different += expected[i] != found[i] ? 1 : 0;
            // Boundary pixels are counted by the same triangles; elsewhere the count is the same by construction.
            EXPECT_EQ(different, 0u) << scene << " " << size.x << "x" << size.y;
        }
}

TEST(VolumeTiled, CountsPerPixelOnlyWhereTheBoundaryPasses) {
    const RenderResult result = shadowOf("in-shadow", "shadow/volume-tiled", 640, 360);
    const double boundary = result.counters.at("tiles of the boundary"), dark = result.counters.at("dark tiles"),
                 lit = result.counters.at("lit tiles");
    // A view of big smooth shapes: boundaries are lines, and most of the picture lies between them.
    EXPECT_GT(boundary, 100);
    EXPECT_LT(boundary, 0.3 * (dark + lit));
    EXPECT_GT(dark, 500);
    EXPECT_GT(lit, 300);
    EXPECT_GT(result.counters.at("fill saved"), 0.7 * result.counters.at("fill of z-fail"));
}

}  // namespace
}  // namespace ombrage::test
