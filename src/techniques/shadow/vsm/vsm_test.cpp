// SPDX-License-Identifier: MIT
#include <numeric>

#include <gtest/gtest.h>

#include "techniques/shared/moment_params.h"

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

}  // namespace
}  // namespace ombrage
