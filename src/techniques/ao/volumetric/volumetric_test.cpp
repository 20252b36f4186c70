// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "techniques/ao/volumetric/own.h"
#include "techniques/floor_and_wall.h"
#include "techniques/open_plane.h"

namespace ombrage::volumetric {
namespace {

TEST(Volumetric, ClaimsTheFreeVolumeBesideAWall) {
    VolumetricParams params;
    for (const bool clip : {true, false})
        for (const double c : {0.1, 0.5, 0.9}) {
            params.clip = clip;
            EXPECT_NEAR(test::meanOf(*makeIntegrand(params), test::FloorAndWall::receiver(), test::FloorAndWall(c)),
                        1 - test::beyondWall(c), test::kMeanTolerance);
        }
}

TEST(Volumetric, SurfacesEndAfterTheirThickness) {
    // A sheet five radii in front of the receiver, four and more in front of the half ball's points.
    const double expected[] = {0, 1, 0};
    const float thicknesses[] = {0, 4, 5};
    for (int i = 0; i < 3; ++i) {
        VolumetricParams params;
        params.thickness = thicknesses[i];
        EXPECT_DOUBLE_EQ(test::meanOf(*makeIntegrand(params), test::SheetInFront::receiver(), test::SheetInFront(5)),
                         expected[i]);
    }
}

// Lines and points exactly. Areas by mean and variance of depths in 32-bit floats: what is left of the difference of
// two equal variances, times the softness of a scale of 1e-4.
TEST(Volumetric, LeavesAPlaneOpen) {
    for (const bool orthographic : {false, true}) {
        EXPECT_GE(test::darkestOfOpenPlane("ao/volumetric", orthographic), 0.999f);
        EXPECT_EQ(test::darkestOfOpenPlane("ao/volumetric:sampling=points,samples=33", orthographic), 1);
        for (const char* depths : {"normal", "steps"})
            EXPECT_GE(test::darkestOfOpenPlane(std::string("ao/volumetric:sampling=areas,samples=1,depths=") + depths,
                                               orthographic),
                      0.97f);
    }
}

}  // namespace
}  // namespace ombrage::volumetric
