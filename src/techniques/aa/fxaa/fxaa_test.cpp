// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <ombrage/renderer.h>

#include "techniques/slanted_edge.h"

namespace ombrage::test {
namespace {

constexpr int kSize = SlantedEdge::kSize_px;

/// sRGB-encoded, which is what FXAA works on.
std::vector<float> pictureOf(double slope, const std::string& aa, bool upright = true) {
    std::vector<float> grey = SlantedEdge::picture(slope, aa, upright);
    for (float& v : grey) v = srgbFromLinear(v);
    return grey;
}

double rmseAgainstCoverage(const std::vector<float>& grey, double slope) {
    return SlantedEdge::rmse(grey, slope);
}

double mean(const std::vector<float>& values) {
    double sum = 0;
    for (float v : values) sum += double(v);
    return sum / double(values.size());
}

TEST(Fxaa, SlantedEdgeBecomesGraded) {
    // Steps of 5 pixels: every quality follows them to both ends.
    const double slope = 0.2;
    const std::vector<float> hard = pictureOf(slope, "aa/none");
    for (const float v : hard) EXPECT_TRUE(v < 1e-3f || v > 0.999f) << v;
    for (const char* quality : {"low", "medium", "high"}) {
        const std::vector<float> soft = pictureOf(slope, std::string("aa/fxaa:quality=") + quality);
        std::vector<float> levels;
        for (const float v : soft)
            if (v > 0.02f && v < 0.98f) levels.push_back(std::round(v * 20));
        std::sort(levels.begin(), levels.end());
        const auto distinct = std::unique(levels.begin(), levels.end()) - levels.begin();
        // A step of 5 pixels has 5 different coverages; both ends of a blend may fall together.
        EXPECT_GE(distinct, 4) << quality;
        // Half of the staircase's error at least: the blend is linear along each step, as coverage is, but reaches
        // only half a pixel.
        EXPECT_LT(rmseAgainstCoverage(soft, slope), 0.5 * rmseAgainstCoverage(hard, slope)) << quality;
        // What one side of the edge gives the other takes: at most one step of 5 pixels at either border of the
        // picture, of 16384, is without its partner.
        EXPECT_NEAR(mean(soft), mean(hard), 5.0 / (kSize * kSize)) << quality;
    }
}

TEST(Fxaa, StraightEdgesAndFlatAreasKeepTheirBits) {
    for (const bool upright : {true, false}) {
        const std::vector<float> hard = pictureOf(0, "aa/none", upright);
        EXPECT_EQ(pictureOf(0, "aa/fxaa:subpix=0", upright), hard);
        // With the subpixel blend a pixel at a straight edge is 1/3 away from its neighbourhood's mean: smoothstep
        // gives 7/27, its square times 0.75 moves it by 0.0504 pixels, and half floats round by 0.0005.
        const std::vector<float> soft = pictureOf(0, "aa/fxaa", upright);
        std::size_t changed = 0;
        float largest = 0;
        for (std::size_t i = 0; i < hard.size(); ++i) {
            changed += hard[i] != soft[i] ? 1 : 0;
            largest = std::max(largest, std::abs(hard[i] - soft[i]));
        }
        EXPECT_LE(changed, std::size_t(2 * kSize));
        EXPECT_NEAR(largest, 0.0504f, 0.001f);
    }
}

TEST(Fxaa, WeakEdgesAreLeftByTheThreshold) {
    // A grey of 10 % contrast is under the highest threshold and over the lowest.
    const auto render = [](const std::string& aa) {
        Scene scene = emptyScene(kSize);
        const float reach = kSize;
        addQuad(scene, {{-reach, -reach, -1}, {reach, -reach, -1}, {reach, reach, -1}, {-reach, reach, -1}}, 0.5f);
        addQuad(scene, {{-0.2f * reach, -reach, 0}, {reach, -reach, 0}, {reach, reach, 0}, {0.2f * reach, reach, 0}},
                0.62f);
        RenderSettings settings = squareSettings(kSize);
        settings.aa = parsePipeline(Family::Aa, aa);
        const auto plane = renderFlat(scene, settings).picture;
        return std::vector<float>(plane.plane(0).begin(), plane.plane(0).end());
    };
    const std::vector<float> hard = render("aa/none");
    EXPECT_EQ(render("aa/fxaa:edge-threshold=0.5"), hard);
    EXPECT_NE(render("aa/fxaa:edge-threshold=0.01,edge-threshold-min=0"), hard);
}

}  // namespace
}  // namespace ombrage::test
