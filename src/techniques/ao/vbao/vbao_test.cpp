// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "techniques/ao/vbao/own.h"
#include "techniques/strip_over_floor.h"

namespace ombrage::vbao {
namespace {

TEST(Vbao, ClaimsThatLightPassesUnderWhatIsThin) {
    // As for gtao's horizons: a march of 256 steps over 20 m finds the edges to about 4 cm, 0.015 of visibility.
    VbaoParams params;
    params.thickness_m = 0.2f;
    const test::StripOverFloor narrow{1, 2, 1};
    EXPECT_NEAR(test::meanOverFloor(*makeIntegrand(params), test::StripProbe(narrow), 20), narrow.overGap(0.2), 0.015);
    // Endlessly thick is a horizon.
    params.thickness_m = 100;
    EXPECT_NEAR(test::meanOverFloor(*makeIntegrand(params), test::StripProbe(narrow), 20), narrow.underHorizon(),
                0.015);
    // Uniform sectors weigh what grazes the floor more than the cosine does: darker.
    const double cosine = test::meanOverFloor(*makeIntegrand(params), test::StripProbe(narrow), 20);
    params.sectors = Sectors::Uniform;
    EXPECT_LT(test::meanOverFloor(*makeIntegrand(params), test::StripProbe(narrow), 20), cosine);
}

TEST(Vbao, ABareFloorIsOpenAndAStripHidesItsShare) {
    for (const float v : test::StripPicture(0).row("ao/vbao:radius=40")) EXPECT_EQ(v, 1.0f);

    // Edges to a pixel and a half as for gtao, and sectors of 1/32 whose errors differ from slice to slice.
    const std::string fine = "ao/vbao:radius=60,slices=32,steps=64,power=1,rotation=none,thickness=";
    const auto thick = test::StripPicture(10).row(fine + "100"), thin = test::StripPicture(10).row(fine + "2");
    for (const int x : {4, 8, 16, 24}) {
        const test::StripOverFloor strip{x + 0.5, x + 10.5, 8};
        EXPECT_NEAR(double(thick[std::size_t(x)]), strip.underHorizon(), 0.03) << x;
        EXPECT_NEAR(double(thin[std::size_t(x)]), strip.overGap(2), 0.03) << x;
    }
}

}  // namespace
}  // namespace ombrage::vbao
