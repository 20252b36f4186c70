// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include "techniques/shadow/evsm/warp.h"
#include "techniques/two_sheets_scene.h"

namespace ombrage {
namespace {

using test::TwoSheets;

/// Chebyshev's bound for a share of the depth `a` and the rest at `b`, at the depth t, all of them warped.
double bound(double share, double a, double b, double t) {
    const double mean = share * a + (1 - share) * b, variance = share * (1 - share) * (a - b) * (a - b);
    return t <= mean ? 1 : variance / (variance + (t - mean) * (t - mean));
}

TEST(ExponentialVariance, ExponentsAreWhatTheFormatHolds) {
    EXPECT_DOUBLE_EQ(evsm::largestExponent(16), 5.5);   // exp(2 * 5.545) = 65504
    EXPECT_DOUBLE_EQ(evsm::largestExponent(32), 44.3);  // exp(2 * 44.36) = 3.4e38
}

TEST(ExponentialVariance, UnderTwoCastersItLeaksByTheBoundOfTheWarpedDepths) {
    const TwoSheets sheets(true);
    const double upper = TwoSheets::depthOf(20), lower = TwoSheets::depthOf(11), floor = TwoSheets::depthOf(0);
    const auto positive = [](double z) { return std::exp(z); };
    const auto negative = [](double z) { return -std::exp(-1.0 * z); };
    const std::string plain = TwoSheets::plain("shadow/evsm", ",min-deviation=0,exponent=1,negative-exponent=1");
    const std::vector<float> two = sheets.row(plain + ",moments=2,bits=32f"),
                             four = sheets.row(plain + ",moments=4,bits=32f"),
                             half = sheets.row(plain + ",moments=4,bits=16f");
    for (int i = 40; i < 88; ++i) {
        const double share = TwoSheets::freeShare(i);
        const double byPositive = bound(share, positive(lower), positive(upper), positive(floor));
        const double byNegative = bound(share, negative(lower), negative(upper), negative(floor));
        // Bounds change by up to 0.01 a texel, and a lookup lies up to a twentieth of one off its middle.
        EXPECT_NEAR(two[std::size_t(i)], byPositive, 5e-4) << i;
        EXPECT_NEAR(four[std::size_t(i)], std::min(byPositive, byNegative), 5e-4) << i;
        // The least variance of 16 bits is a 512th of the mean square.
        EXPECT_NEAR(half[std::size_t(i)], std::min(byPositive, byNegative), 5e-3) << i;
    }
    EXPECT_GT(bound(0.5, positive(lower), positive(upper), positive(floor)), 0.01);
    EXPECT_NE(two, four);
}

TEST(ExponentialVariance, WithItsOwnExponentsNothingLeaksUnderTwoCasters) {
    for (const char* more : {",moments=2,bits=32f", ",moments=4,bits=32f"}) {
        const std::vector<float> row = TwoSheets(true).row(TwoSheets::plain("shadow/evsm", more));
        // exp(-42 z) over 0.9 of z is 1e-16, squared.
        for (std::size_t i = 40; i < 88; ++i) EXPECT_LT(row[i], 1e-5f) << more << i;
    }
}

}  // namespace
}  // namespace ombrage
