// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "techniques/shadow/lvsm/layers.h"
#include "techniques/two_sheets_scene.h"

namespace ombrage {
namespace {

std::vector<std::uint32_t> histogramOf(const std::vector<std::pair<std::size_t, std::uint32_t>>& counts) {
    std::vector<std::uint32_t> histogram(16);
    for (const auto& [bin, count] : counts) histogram[bin] = count;
    return histogram;
}

TEST(LayeredVariance, TwoDepthsAreCutInTheMiddleBetweenThem) {
    // Bins 2 and 13 of 16 lie at -0.6875 and 0.6875.
    EXPECT_EQ(lvsm::placeLayers(histogramOf({{2, 7}, {13, 9000}}), 2), (std::vector<float>{-1, 0, 1}));
    // No third layer without a third depth.
    EXPECT_EQ(lvsm::placeLayers(histogramOf({{2, 7}, {13, 9000}}), 4), (std::vector<float>{-1, 0, 1}));
    EXPECT_EQ(lvsm::placeLayers(histogramOf({{5, 3}}), 4), (std::vector<float>{-1, 1}));
    EXPECT_EQ(lvsm::placeLayers(histogramOf({}), 4), (std::vector<float>{-1, 1}));
}

TEST(LayeredVariance, TheCutHasTheLeastSpread) {
    // Bins 0, 1 | 7, 8: by hand, 2 and 2 of equal counts. Cut between bins 1 and 7, whose middle is bin 4's.
    const std::vector<float> ends = lvsm::placeLayers(histogramOf({{0, 5}, {1, 5}, {7, 5}, {8, 5}}), 2);
    ASSERT_EQ(ends.size(), 3u);
    EXPECT_FLOAT_EQ(ends[1], -1 + 4.5f / 8);
    // Three layers part the pair that weighs more.
    const std::vector<float> three = lvsm::placeLayers(histogramOf({{0, 5}, {1, 5}, {7, 50}, {8, 50}}), 3);
    ASSERT_EQ(three.size(), 4u);
    EXPECT_FLOAT_EQ(three[1], -1 + 4.5f / 8);
    EXPECT_FLOAT_EQ(three[2], 0);
}

TEST(LayeredVariance, LayersReachBeyondTheirEnds) {
    const std::vector<glm::vec4> spans = lvsm::layerSpans({-1, -0.5f, 1}, 0.2f, 3);
    ASSERT_EQ(spans.size(), 3u);
    // The first is 0.5 deep and goes 0.1 farther; the second is 1.5 deep and begins 0.1 before.
    EXPECT_FLOAT_EQ(spans[0].x, -1);
    EXPECT_FLOAT_EQ(spans[0].y, 1 / 0.6f);
    EXPECT_FLOAT_EQ(spans[0].z, -0.5f);
    EXPECT_FLOAT_EQ(spans[1].x, -0.6f);
    EXPECT_FLOAT_EQ(spans[1].y, 1 / 1.6f);
    // What is asked for beyond them holds nothing.
    EXPECT_GT(spans[2].x, 1);
}

TEST(LayeredVariance, ASecondLayerStopsTheLeakUnderTwoCasters) {
    const test::TwoSheets sheets(true);
    const auto leakAt = [&](const char* layers) {
        const std::vector<float> row =
            sheets.row(test::TwoSheets::plain("shadow/lvsm", std::string(",min-deviation=0,bits=32f,") + layers));
        return 0.5f * (row[63] + row[64]);
    };
    // One layer is a variance shadow map: 20.25 / (20.25 + 15.5^2).
    EXPECT_NEAR(leakAt("layers=1"), 0.0777f, 2e-3f);
    // Cut half way, and from there to the floor: both sheets have depth 0.
    EXPECT_LT(leakAt("layers=2,placement=even,overlap=0"), 1e-5f);
    // Begun 1.336 m before, at 8.684 m, the layer holds the lower sheet at 0.336 of its 11.356 m, the floor at 0.998.
    const double mean = 0.5 * 0.0296, variance = mean * mean, beyond = 0.998 - mean;
    EXPECT_NEAR(leakAt("layers=2,placement=even,overlap=0.13333"), variance / (variance + beyond * beyond), 5e-5);
}

}  // namespace
}  // namespace ombrage
