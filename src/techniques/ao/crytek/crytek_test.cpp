// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "techniques/ao/crytek/own.h"
#include "techniques/floor_and_wall.h"
#include "techniques/open_plane.h"

namespace ombrage::crytek {
namespace {

TEST(Crytek, ClaimsTheFreeVolumeBesideAWall) {
    CrytekParams params;
    params.range = 1000;
    for (const double c : {0.1, 0.5, 0.9})
        EXPECT_NEAR(test::meanOf(*makeIntegrand(params), test::FloorAndWall::receiver(), test::FloorAndWall(c)),
                    1 - test::beyondWall(c), test::kMeanTolerance);
    params.remap = false;
    EXPECT_NEAR(test::meanOf(*makeIntegrand(params), test::FloorAndWall::receiver(), test::FloorAndWall(0.5)),
                0.5 * (1 - test::beyondWall(0.5)), test::kMeanTolerance);
}

TEST(Crytek, TakesWhatStandsFarInFrontForFlat) {
    // Five radii in front: beyond twice the range; a quarter of the way there; within it.
    const double expected[] = {1, 0.25, 0}, ranges[] = {1, 4, 6};
    for (int i = 0; i < 3; ++i) {
        CrytekParams params;
        params.range = float(ranges[i]);
        EXPECT_DOUBLE_EQ(test::meanOf(*makeIntegrand(params), test::SheetInFront::receiver(), test::SheetInFront(5)),
                         expected[i]);
    }
}

// Depths are those of pixels' middles, so that points next to the plane may be found on its wrong side: of the 16 pairs at
// most three have lost a point here. Without pairs 6 of 32 points more than half, and more, are hidden by chance.
TEST(Crytek, LeavesAPlaneOpen) {
    for (const bool orthographic : {false, true})
        EXPECT_GE(test::darkestOfOpenPlane("ao/crytek", orthographic), 1 - 3.0f / 16);
}

}  // namespace
}  // namespace ombrage::crytek
