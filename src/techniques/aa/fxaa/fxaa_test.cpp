// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <ombrage/renderer.h>

#include "techniques/flat_scene_picture.h"

namespace ombrage::test {
namespace {

constexpr int kSize = 128;

/// sRGB-encoded grey of a white half plane on black whose edge leaves the vertical by `slope`, through `aa`.
std::vector<float> pictureOf(double slope, const std::string& aa, bool upright = true) {
    // The half plane's edge passes the picture's centre; it reaches beyond the picture on all other sides.
    Scene scene = emptyScene(kSize);
    const float reach = kSize, lean = float(slope) * reach;
    const auto corner = [&](float along, float across) {
        return upright ? glm::vec3(across, along, 0) : glm::vec3(along, across, 0);
    };
    addQuad(scene, {corner(-reach, -lean), corner(-reach, reach), corner(reach, reach), corner(reach, lean)}, 1.0f);
    RenderSettings settings = squareSettings(kSize);
    settings.aa = parsePipeline(Family::Aa, aa);
    const RenderResult result = renderFlat(scene, settings);
    std::vector<float> grey;
    for (float linear : result.picture.plane(0)) grey.push_back(srgbFromLinear(linear));
    return grey;
}

/// Share of the pixel's area that lies to the right of the edge x = slope * y through the picture's centre.
double coverage(double slope, int column, int row) {
    constexpr int kGrid = 32;
    int inside = 0;
    for (int j = 0; j < kGrid; ++j)
        for (int i = 0; i < kGrid; ++i) {
            const double x = column + (i + 0.5) / kGrid - 0.5 * kSize, y = 0.5 * kSize - row - (j + 0.5) / kGrid;
            inside += x > slope * y ? 1 : 0;
        }
    return double(inside) / (kGrid * kGrid);
}

double rmseAgainstCoverage(const std::vector<float>& grey, double slope) {
    double sum = 0;
    for (int row = 0; row < kSize; ++row)
        for (int column = 0; column < kSize; ++column) {
            const double e = double(grey[std::size_t(row * kSize + column)]) - coverage(slope, column, row);
            sum += e * e;
        }
    return std::sqrt(sum / (kSize * kSize));
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
