// SPDX-License-Identifier: MIT
#include <algorithm>

#include <gtest/gtest.h>

#include "techniques/slanted_edge.h"

namespace ombrage::test {
namespace {

// The border lacks the ends of edges that leave the picture.
constexpr int kBorder_px = 16;

double rmseOf(double slope, const std::string& aa, double shift_px = 0) {
    return SlantedEdge::rmse(SlantedEdge::picture(slope, aa, true, shift_px), slope, kBorder_px, shift_px);
}

TEST(Smaa, ALongStaircaseBecomesTheTrueCoverage) {
    // Steps of 8 pixels, shifted so that no step falls on the border of two pixels: the line through the middle of the
    // crossing edges is the edge itself, but for a shift of less than half a pixel's step: 1/16 of a pixel.
    const double slope = 1.0 / 8;
    const double hard = rmseOf(slope, "aa/none", 0.06), soft = rmseOf(slope, "aa/smaa", 0.06);
    ASSERT_GT(hard, 0.02);
    EXPECT_LT(soft, 0.25 * hard);
    // Low quality follows an edge for 8 pixels each way, which is enough here; 1 step is not.
    EXPECT_GT(rmseOf(slope, "aa/smaa:preset=custom,search-steps=1", 0.06), 2 * soft);
}

TEST(Smaa, DiagonalsAreFollowedAsSuch) {
    // A slope of 6 in 7: six single steps, then one of two pixels.
    const double slope = 6.0 / 7;
    const double hard = rmseOf(slope, "aa/none", 0.03);
    const double straight = rmseOf(slope, "aa/smaa:preset=custom,diagonal-steps=0,corner-rounding=1", 0.03);
    const double diagonal = rmseOf(slope, "aa/smaa:preset=custom,corner-rounding=1", 0.03);
    EXPECT_LT(straight, 0.6 * hard);
    EXPECT_LT(diagonal, 0.75 * straight);
}

TEST(Smaa, StraightEdgesAndFlatAreasKeepTheirBits) {
    for (const bool upright : {true, false})
        for (const char* preset : {"low", "medium", "high", "ultra"})
            EXPECT_EQ(SlantedEdge::picture(0, std::string("aa/smaa:preset=") + preset, upright),
                      SlantedEdge::picture(0, "aa/none", upright));
}

TEST(Smaa, ATurnedSceneGivesTheTurnedPicture) {
    // Rows and columns change roles: the picture of the level edge is the transpose of that of the upright one.
    const int n = SlantedEdge::kSize_px;
    for (const double slope : {0.15, 0.4, 0.9}) {
        const auto upright = SlantedEdge::picture(slope, "aa/smaa", true, 0.1),
                   level = SlantedEdge::picture(slope, "aa/smaa", false, 0.1);
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x)
                // Counted from the lower left, x and y change places.
                ASSERT_EQ(upright[std::size_t((n - 1 - y) * n + x)], level[std::size_t((n - 1 - x) * n + y)])
                    << slope << " at " << x << " " << y;
    }
}

TEST(Smaa, CornersKeepTheirShape) {
    // A white square of 40 pixels: its outline is level and upright, so only its corners can be blended.
    Scene scene = emptyScene(SlantedEdge::kSize_px);
    addQuad(scene, {{-20, -20, 0}, {20, -20, 0}, {20, 20, 0}, {-20, 20, 0}}, 1.0f);
    const auto lost = [&](const std::string& aa) {
        const auto soft = SlantedEdge::picture(scene, aa), hard = SlantedEdge::picture(scene, "aa/none");
        double sum = 0;
        for (std::size_t i = 0; i < soft.size(); ++i) sum += std::abs(double(soft[i]) - double(hard[i]));
        return sum;
    };
    const double sharp = lost("aa/smaa:preset=custom,corner-rounding=0"),
                 some = lost("aa/smaa:preset=custom,corner-rounding=0.25"),
                 round = lost("aa/smaa:preset=custom,corner-rounding=1");
    EXPECT_EQ(sharp, 0.0);
    EXPECT_GT(some, 0.0);
    // A quarter of the strength is kept: weights of 8 bits.
    EXPECT_NEAR(some, 0.25 * round, 0.03 * round);
}

}  // namespace
}  // namespace ombrage::test
