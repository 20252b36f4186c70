// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include "techniques/ao/ssdo/own.h"
#include "techniques/floor_and_wall.h"
#include "techniques/open_plane.h"

namespace ombrage::ssdo {
namespace {

TEST(Ssdo, ClaimsAWallByTheShareOfEachDirectionBehindIt) {
    // The cosine a of a direction to the wall has the density 2/pi sqrt(1 - a^2) over both signs; 1 - c/a of the
    // direction is behind the wall. Integrated from c to 1.
    for (const double c : {0.1, 0.5, 0.9}) {
        const double s = std::sqrt(1 - c * c);
        const double hidden = (std::acos(c) - c * s - 2 * c * (std::log((1 + s) / c) - s)) / 3.14159265358979;
        EXPECT_NEAR(test::meanOf(*makeIntegrand({}), test::FloorAndWall::receiver(), test::FloorAndWall(c)), 1 - hidden,
                    test::kMeanTolerance);
    }
}

TEST(Ssdo, WhateverHidesAPointBlocksItsDirection) {
    EXPECT_DOUBLE_EQ(test::meanOf(*makeIntegrand({}), test::SheetInFront::receiver(), test::SheetInFront(5)), 0);
}

// Exactly: what lies over the plane is not hidden by it.
TEST(Ssdo, LeavesAPlaneOpen) {
    for (const bool orthographic : {false, true}) EXPECT_EQ(test::darkestOfOpenPlane("ao/ssdo", orthographic), 1);
}

}  // namespace
}  // namespace ombrage::ssdo
