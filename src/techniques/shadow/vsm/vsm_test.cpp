// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "techniques/shared/moment_params.h"
#include "techniques/two_sheets_scene.h"

namespace ombrage {
namespace {

double total(const std::vector<float>& weights) {
    double sum = -double(weights[0]);
    for (float weight : weights) sum += 2 * double(weight);
    return sum;
}

TEST(MomentBlurs, WeightsSumToOne) {
    for (const MomentBlur blur : {MomentBlur::Gauss, MomentBlur::Box})
        for (int width = 1; width <= 31; ++width) {
            const std::vector<float> weights = momentBlurWeights(blur, width);
            ASSERT_EQ(weights.size(), std::size_t(width / 2 + 1));
            // Up to 31 roundings of floats below 1.
            EXPECT_NEAR(total(weights), 1, 31 * 6e-8) << width;
        }
}

TEST(MomentBlurs, ABoxIsEvenWithHalfTexelsAtTheEndsOfEvenWidths) {
    EXPECT_EQ(momentBlurWeights(MomentBlur::Box, 3), (std::vector<float>{1 / 3.0f, 1 / 3.0f}));
    EXPECT_EQ(momentBlurWeights(MomentBlur::Box, 4), (std::vector<float>{0.25f, 0.25f, 0.125f}));
}

TEST(MomentBlurs, AGaussianHasTheSharesOfItsIntegral) {
    // Width 4: one texel of deviation. Shares of the texels up to two deviations, of what lies within two.
    const std::vector<float> weights = momentBlurWeights(MomentBlur::Gauss, 4);
    ASSERT_EQ(weights.size(), 3u);
    // From a table of the normal distribution: P(|x|<0.5) = 0.38292, P(|x|<1.5) = 0.86639, P(|x|<2) = 0.95450.
    EXPECT_NEAR(weights[0], 0.38292 / 0.95450, 1e-5);
    EXPECT_NEAR(weights[1], 0.5 * (0.86639 - 0.38292) / 0.95450, 1e-5);
    EXPECT_NEAR(weights[2], 0.5 * (0.95450 - 0.86639) / 0.95450, 1e-5);
}

TEST(MomentBlurs, VarianceOfABoxIsThatOfItsTexels) {
    // (n^2 - 1)/12 for n equal weights a texel apart.
    EXPECT_NEAR(momentBlurVariance(momentBlurWeights(MomentBlur::Box, 5)), 2.0f, 1e-5f);
    EXPECT_EQ(momentBlurVariance(momentBlurWeights(MomentBlur::Gauss, 1)), 0);
}

/// From where on a row of pixels is under the box of an edge on both of its sides.
constexpr int kFrom_px = 40, kTo_px = 88;

TEST(VarianceShadowMap, AStraightEdgeBlursToTheKernelsIntegral) {
    // With two depths, the receiver's being one of them, Chebyshev's bound is the share itself: half at the edge.
    const std::vector<float> row = test::TwoSheets(false).row(test::TwoSheets::plain("shadow/vsm"));
    for (int i = kFrom_px; i < kTo_px; ++i)
        // At the box's ends the lookup between texels rounds the corner: an eighth of a texel's share.
        EXPECT_NEAR(row[std::size_t(i)], test::TwoSheets::freeShare(i), 0.125 / 31 + 1e-3) << i;
}

TEST(VarianceShadowMap, UnderTwoCastersItLeaksByChebyshevsBound) {
    for (const char* bits : {"32f", "16"}) {
        const std::vector<float> row = test::TwoSheets(true).row(
            test::TwoSheets::plain("shadow/vsm", std::string(",min-deviation=0,bits=") + bits));
        for (int i = kFrom_px; i < kTo_px; ++i) {
            // Metres below the upper sheet: 0 and 9, and 20 for the floor.
            const double share = test::TwoSheets::freeShare(i), mean = 9 * share, variance = 81 * share * (1 - share);
            // A step of 16 bits in the mean of squares, of which the whole range is 400 square metres.
            EXPECT_NEAR(row[std::size_t(i)], variance / (variance + (20 - mean) * (20 - mean)), 2e-3) << bits << i;
        }
        // Half and half: 20.25 / (20.25 + 15.5^2).
        EXPECT_NEAR(0.5f * (row[63] + row[64]), 0.0777f, 2e-3f) << bits;
    }
}

TEST(VarianceShadowMap, BleedingReductionStretchesWhatIsAbove) {
    const test::TwoSheets sheets(false);
    const std::vector<float> plain = sheets.row(test::TwoSheets::plain("shadow/vsm"));
    std::string half = test::TwoSheets::plain("shadow/vsm");
    half.replace(half.find("bleeding=0"), 10, "bleeding=0.5");
    const std::vector<float> cut = sheets.row(half);
    // Twice the rounding of a 16-bit float below 1.
    for (std::size_t i = kFrom_px; i < kTo_px; ++i) EXPECT_NEAR(cut[i], std::max(0.0f, 2 * plain[i] - 1), 2e-3f) << i;
}

TEST(MomentMaps, CastersWithoutNumbersLeaveThemAlone) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();
    for (const char* technique : {"shadow/vsm", "shadow/esm", "shadow/evsm", "shadow/evsm:bits=16f", "shadow/lvsm",
                                  "shadow/msm", "shadow/msm:bits=32f,reconstruction=hausdorff"}) {
        SCOPED_TRACE(technique);
        const std::vector<float> sound = test::TwoSheets(false).picture(technique);
        EXPECT_EQ(*std::min_element(sound.begin(), sound.end()), 0.0f);
        EXPECT_EQ(*std::max_element(sound.begin(), sound.end()), 1.0f);
        // Both triangles of the quad have the broken corner; one that is merely far away is another scene.
        for (const float broken : {kNan, kInf, -kInf, 3e38f}) {
            test::TwoSheets sheets(false);
            sheets.addLevel(test::TwoSheets::kUpper_m, 8, 16, 8);
            sheets.scene.meshes.back().positions[2] = glm::vec3(broken);
            const std::vector<float> shown = sheets.picture(technique);
            if (broken == 3e38f) {
                for (float visibility : shown) ASSERT_TRUE(visibility >= 0 && visibility <= 1);
            } else {
                EXPECT_EQ(shown, sound) << broken;
            }
        }
    }
}

}  // namespace
}  // namespace ombrage
