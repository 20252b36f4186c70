// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <gtest/gtest.h>
#include <ombrage/error.h>

#include "techniques/slanted_edge.h"
#include "techniques/technique_case.h"

namespace ombrage::test {
namespace {

RenderResult renderSmall(const std::string& scene, const std::string& aa, int scale = 1) {
    RenderSettings settings;
    settings.width = 160 * scale;
    settings.height = 90 * scale;
    settings.shadow = parsePipeline(Family::Shadow, "shadow/ray-traced");
    settings.aa = parsePipeline(Family::Aa, aa);
    RenderResult result = renderScene(Bench::of(scene).scene(), settings);
    EXPECT_TRUE(result.debugMessages.empty()) << result.debugMessages.front();
    return result;
}

TEST(Ssaa, OrderedSamplesAreThePixelsOfALargerPicture) {
    for (const char* scene : {"menger", "cornell"}) {
        const Image fine = renderSmall(scene, "aa/none", 4).picture,
                    mean = renderSmall(scene, "aa/ssaa:grid=4").picture;
        std::size_t differing = 0;
        for (int p = 0; p < 3; ++p)
            for (int y = 0; y < mean.height(); ++y)
                for (int x = 0; x < mean.width(); ++x) {
                    double sum = 0;
                    for (int j = 0; j < 4; ++j)
                        for (int i = 0; i < 4; ++i)
                            sum += double(fine.plane(p)[std::size_t((4 * y + j) * fine.width() + 4 * x + i)]) / 16;
                    const double is = double(mean.plane(p)[std::size_t(y * mean.width() + x)]);
                    // Half floats, rounded down: 2^-10; shading's own rounding on top.
                    differing += std::abs(is - sum) > 0.002 * (1 + sum) ? 1 : 0;
                }
        // A sample on an outline may fall to either side where floats differ: one in 500 of all values.
        EXPECT_LE(differing, std::size_t(mean.width() * mean.height() * 3 / 500)) << scene;
    }
}

TEST(Ssaa, ASlantedEdgeHasItsCoverage) {
    for (const char* pattern : {"ordered", "rotated"})
        for (const double slope : {0.0, 0.03, 0.37, 1.0}) {
            const auto grey = SlantedEdge::picture(slope, std::string("aa/ssaa:grid=8,pattern=") + pattern, true, 0.21);
            // 64 samples of an edge are wrong by one row of the grid at most, an 8th, in the pixels that it crosses.
            for (int row = 0; row < SlantedEdge::kSize_px; ++row)
                for (int column = 0; column < SlantedEdge::kSize_px; ++column)
                    ASSERT_NEAR(double(grey[std::size_t(row * SlantedEdge::kSize_px + column)]),
                                SlantedEdge::coverage(slope, column, row, 0.21), 0.126);
            EXPECT_LT(SlantedEdge::rmse(grey, slope, 0, 0.21), 0.01);
        }
}

TEST(Ssaa, RotatedSamplesGiveALevelEdgeMoreGrades) {
    // An upright edge at 16 places within a pixel: as many grades as there are columns of samples, and none.
    const auto grades = [](const std::string& pattern) {
        std::set<int> found;
        for (int i = 0; i < 16; ++i) {
            const auto grey = SlantedEdge::picture(0, "aa/ssaa:grid=4,pattern=" + pattern, true, 0.01 + i / 16.0);
            found.insert(int(std::lround(double(grey[std::size_t(64 * SlantedEdge::kSize_px + 64)]) * 16)));
        }
        return found.size();
    };
    EXPECT_EQ(grades("ordered"), 5u);
    EXPECT_EQ(grades("rotated"), 16u);
}

TEST(Ssaa, OneSampleChangesNothingAndOthersMayFollow) {
    EXPECT_EQ(SlantedEdge::picture(0.3, "aa/ssaa:grid=1"), SlantedEdge::picture(0.3, "aa/none"));
    EXPECT_NE(SlantedEdge::picture(0.3, "aa/ssaa:grid=2+aa/fxaa"), SlantedEdge::picture(0.3, "aa/ssaa:grid=2"));
    EXPECT_THROW(SlantedEdge::picture(0.3, "aa/fxaa+aa/ssaa"), Error);
}

TEST(Ssaa, EveryTechniquesPassesAreCountedForEverySample) {
    const RenderResult one = renderSmall("menger", "aa/none"), four = renderSmall("menger", "aa/ssaa:grid=2");
    const auto draws = [](const RenderResult& result, const std::string& name) {
        for (const PassCost& pass : result.passes)
            if (pass.name == name) return pass.draws;
        return std::uint64_t(0);
    };
    EXPECT_EQ(draws(four, "g-buffer"), 4 * draws(one, "g-buffer"));
    EXPECT_EQ(draws(four, "ssaa resolve"), 1u);
}

/// Of display values, all channels.
double psnrBetween(const Image& a, const Image& b) {
    double sum = 0;
    std::size_t count = 0;
    for (int p = 0; p < 3; ++p)
        for (std::size_t i = 0; i < a.plane(p).size(); ++i, ++count) {
            const auto shown = [](float linear) { return double(srgbFromLinear(std::clamp(linear, 0.0f, 1.0f))); };
            const double e = shown(a.plane(p)[i]) - shown(b.plane(p)[i]);
            sum += e * e;
        }
    return -10 * std::log10(sum / double(count));
}

/// Each pixel the mean of 3x3 with weights (1, 2, 1): what softens edges without knowing where they are.
Image blurred(const Image& image) {
    Image soft = image;
    const int w = image.width(), h = image.height();
    for (int p = 0; p < 3; ++p)
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x) {
                float sum = 0;
                for (int j = -1; j <= 1; ++j)
                    for (int i = -1; i <= 1; ++i)
                        sum +=
                            image.plane(p)[std::size_t(std::clamp(y + j, 0, h - 1) * w + std::clamp(x + i, 0, w - 1))] *
                            float((2 - std::abs(i)) * (2 - std::abs(j))) / 16;
                soft.plane(p)[std::size_t(y * w + x)] = sum;
            }
    return soft;
}

// Every technique of the family must be nearer to the supersampled picture than one sample is, by more than a blur can.
TEST(Ssaa, EveryAntiAliasingIsNearerToItThanNoneAndThanABlur) {
    double blurGain = 0;
    std::map<std::string, double> gains;
    const std::vector<std::string> scenes = {"fence", "bicycle", "comb"};
    for (const std::string& scene : scenes) {
        const auto render = [&](const std::string& aa) {
            RenderSettings settings;
            settings.width = 320;
            settings.height = 180;
            settings.aa = parsePipeline(Family::Aa, aa);
            return renderScene(Bench::of(scene).scene(), settings).picture;
        };
        const Image truth = render("aa/ssaa:grid=8"), none = render("aa/none");
        const double hard = psnrBetween(none, truth);
        blurGain += (psnrBetween(blurred(none), truth) - hard) / double(scenes.size());
        for (const TechniqueInfo& info : techniques())
            if (info.family == Family::Aa && info.id != "aa/none")
                gains[info.id] += (psnrBetween(render(info.id), truth) - hard) / double(scenes.size());
    }
    for (const auto& [id, gain] : gains) {
        // In decibels, the mean over the scenes; measured 2.9 (FXAA) and more.
        EXPECT_GE(gain, 2.7) << id;
    }
    // Measured 2.3: a margin that a blur met would say nothing.
    EXPECT_LT(blurGain, 2.5);
}

}  // namespace
}  // namespace ombrage::test
