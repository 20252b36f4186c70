// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "techniques/ao/starcraft2/own.h"
#include "techniques/floor_and_wall.h"
#include "techniques/open_plane.h"

namespace ombrage::starcraft2 {
namespace {

TEST(Starcraft2, ClaimsTheFreeVolumeBesideAWall) {
    Starcraft2Params params;
    params.full = params.none = 100;
    for (const double c : {0.1, 0.5, 0.9})
        EXPECT_NEAR(test::meanOf(*makeIntegrand(params), test::FloorAndWall::receiver(), test::FloorAndWall(c)),
                    1 - test::beyondWall(c), test::kMeanTolerance);
}

TEST(Starcraft2, FallsOffWithTheDepthBetween) {
    // A sheet five radii in front: nothing at the default; with a straight fall over ten radii the mean height 3/8 of
    // the half ball's points tells.
    Starcraft2Params params;
    const auto mean = [&] {
        return test::meanOf(*makeIntegrand(params), test::SheetInFront::receiver(), test::SheetInFront(5));
    };
    EXPECT_DOUBLE_EQ(mean(), 1);
    params.full = 0;
    params.none = 10;
    EXPECT_NEAR(mean(), 1 - (10 - (5 - 0.375)) / 10, test::kMeanTolerance);
    params.full = 6;
    EXPECT_DOUBLE_EQ(mean(), 0);
}

// Exactly: what lies over the plane is not hidden by it. Half floats hold 1.
TEST(Starcraft2, LeavesAPlaneOpen) {
    for (const bool orthographic : {false, true}) EXPECT_EQ(test::darkestOfOpenPlane("ao/starcraft2", orthographic), 1);
}

}  // namespace
}  // namespace ombrage::starcraft2
