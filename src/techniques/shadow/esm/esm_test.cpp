// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include "techniques/two_sheets_scene.h"

namespace ombrage {
namespace {

using test::TwoSheets;

TEST(ExponentialShadowMap, IsTheMeanOfTheRatiosOfExponentials) {
    const double upper = TwoSheets::depthOf(20), lower = TwoSheets::depthOf(11), floor = TwoSheets::depthOf(0);
    const auto ratio = [&](double z) { return std::exp(2 * (z - floor)); };
    for (const bool withLower : {false, true})
        for (const char* space : {"exp", "log"}) {
            const std::vector<float> row =
                TwoSheets(withLower).row(TwoSheets::plain("shadow/esm", std::string(",exponent=2,space=") + space));
            for (int i = 40; i < 88; ++i) {
                const double share = TwoSheets::freeShare(i);
                // The ends of the box are rounded off as by vsm; logarithms are interpolated between texels, not means.
                EXPECT_NEAR(row[std::size_t(i)], share * ratio(withLower ? lower : floor) + (1 - share) * ratio(upper),
                            0.125 / 31 + 1e-3)
                    << space << withLower << i;
            }
        }
}

TEST(ExponentialShadowMap, LogarithmsHoldExponentsBeyondAFloat) {
    const std::vector<float> row = TwoSheets(false).row(TwoSheets::plain("shadow/esm", ",exponent=2000,space=log"));
    // Between the box's ends the share itself: the upper sheet's ratio is nothing, exp(-4000).
    for (int i = 50; i < 78; ++i) EXPECT_NEAR(row[std::size_t(i)], TwoSheets::freeShare(i), 5e-3) << i;
    EXPECT_LT(row[40], 1e-6f);
    EXPECT_EQ(row[90], 1.0f);
}

}  // namespace
}  // namespace ombrage
