// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "techniques/filter_scenes.h"

namespace ombrage::test {
namespace {

const std::vector<double> kSpline = {1.0 / 16, 1.0 / 4, 3.0 / 8, 1.0 / 4, 1.0 / 16};

/// The kernel of some levels along one axis: splines convolved whose taps stand 1, 2, 4 ... apart; index 0 is its left
/// end.
std::vector<double> kernelOf(int levels) {
    std::vector<double> kernel = {1.0};
    for (int level = 0; level < levels; ++level) {
        const std::size_t apart = std::size_t(1) << level;
        std::vector<double> wider(kernel.size() + 4 * apart, 0.0);
        for (std::size_t i = 0; i < kernel.size(); ++i)
            for (std::size_t tap = 0; tap < 5; ++tap) wider[i + tap * apart] += kernel[i] * kSpline[tap];
        kernel = wider;
    }
    return kernel;
}

TEST(Atrous, OnAPlaneItsLevelsAreSplinesConvolved) {
    for (const int levels : {1, 2, 3}) {
        const std::vector<double> kernel = kernelOf(levels);
        const int reach = int(kernel.size()) / 2;
        const ImpulseResponse response("filter/atrous:levels=" + std::to_string(levels));
        const auto at = [&](int d) { return std::abs(d) <= reach ? kernel[std::size_t(d + reach)] : 0.0; };
        for (int dy = -reach - 1; dy <= reach + 1; ++dy)
            for (int dx = -reach - 1; dx <= reach + 1; ++dx) {
                const double expected = at(dx) * at(dy);
                // A rounding to 11 bits a level, down as it may be; below 6e-5 half floats have steps of 6e-8.
                EXPECT_NEAR(response.at(dx, dy), expected, expected * 0.001 * levels + 2e-7) << dx << " " << dy;
            }
    }
}

/// A step from 0 to 1 through the filter, by its definition along one axis.
std::vector<double> filteredStep(int levels, double sigma) {
    std::vector<double> values(64, 0.0);
    std::fill(values.begin() + 32, values.end(), 1.0);
    for (int level = 0; level < levels; ++level) {
        std::vector<double> next = values;
        for (int i = 0; i < 64; ++i) {
            double sum = 0, total = 0;
            for (int tap = -2; tap <= 2; ++tap) {
                const int at = std::clamp(i + tap * (1 << level), 0, 63);
                const double d = (values[std::size_t(at)] - values[std::size_t(i)]) / (sigma * std::pow(0.5, level));
                const double w = kSpline[std::size_t(tap + 2)] * std::exp(-0.5 * d * d);
                sum += w * values[std::size_t(at)];
                total += w;
            }
            next[std::size_t(i)] = sum / total;
        }
        values = next;
    }
    return values;
}

TEST(Atrous, TheSigmaOfValuesHalvesWithEveryLevel) {
    const Scene scene = lightThroughHole(0, 60, -60, 60);
    for (const int levels : {1, 3}) {
        const std::vector<float> image =
            filteredShadow(scene, "filter/atrous:value-sigma=0.6,levels=" + std::to_string(levels));
        const std::vector<double> expected = filteredStep(levels, 0.6);
        // A rounding to 11 bits a level, which the next one's weights pass on.
        for (int x = -16; x < 16; ++x)
            EXPECT_NEAR(
                double(image[std::size_t(kFilterPicture_px / 2 * kFilterPicture_px + kFilterPicture_px / 2 + x)]),
                expected[std::size_t(32 + x)], 0.002)
                << x << " after " << levels;
    }
    // A step of 1 at a sigma of 0.05 has a weight of exp(-200): the shadow keeps its edge.
    EXPECT_EQ(filteredShadow(scene, "filter/atrous:value-sigma=0.05"), filteredShadow(scene, "filter/none"));
}

TEST(Atrous, NothingBleedsOverAStepAndNoiseFalls) {
    const std::string occlusion = "ao/blocks:rotation=hash+filter/atrous";
    EXPECT_EQ(darkestOnQuad(aoOf(quadBeforeRibs(), occlusion)), 1.0f);
    EXPECT_LT(darkestOnQuad(aoOf(quadBeforeRibs(), occlusion + ":plane-tolerance=1000,normal-power=0")), 0.98f);
    // Three levels are as wide as a Gaussian of sigma 4.6 pixels.
    const std::string noisy = "ao/blocks:samples=16,rotation=hash";
    EXPECT_LT(roughnessOfSlope(noisy + "+filter/atrous"), 0.35 * roughnessOfSlope(noisy));
}

}  // namespace
}  // namespace ombrage::test
