// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "techniques/filter_scenes.h"

namespace ombrage::test {
namespace {

const std::string kOcclusion = "ao/blocks:rotation=hash+filter/bilateral";

TEST(Bilateral, OnAPlaneItIsTheGaussian) {
    const auto weights = gaussianWeights(3, 1.5);
    const ImpulseResponse response("filter/bilateral:radius=3,sigma=1.5");
    // Half floats hold 11 bits and may be rounded down: 2^-10.
    for (int dy = -4; dy <= 4; ++dy)
        for (int dx = -4; dx <= 4; ++dx) {
            const bool isInside = std::abs(dx) <= 3 && std::abs(dy) <= 3;
            const double expected = isInside ? weights[std::size_t(dx + 3)] * weights[std::size_t(dy + 3)] : 0.0;
            EXPECT_NEAR(response.at(dx, dy), expected, expected * 0.001) << dx << " " << dy;
        }
}

TEST(Bilateral, ANeighboursWeightFallsWithItsDistanceFromThePlane) {
    // A floor with a step of h along x = 0, all in shadow but for the half to the right, which lies lower: the pixel
    // left of the step sees the three columns to its right through exp(-h^2 / (2 tolerance^2)).
    const double h = 1.2, tolerance = 0.8;
    Scene scene = lightThroughHole(0, 40, -60, 60);
    const float r = kFilterPicture_px, low = float(-h);
    scene.meshes[0].positions = {{-r, -r, 0}, {0, -r, 0}, {0, r, 0}, {-r, r, 0}};
    addQuad(scene, {{0, -r, low}, {r, -r, low}, {r, r, low}, {0, r, low}}, 0.1f);
    const std::vector<float> image = filteredShadow(scene, "filter/bilateral:radius=3,sigma=1.5,plane-tolerance=0.8");
    const auto weights = gaussianWeights(3, 1.5);
    const double share = std::exp(-0.5 * h * h / (tolerance * tolerance));
    for (int x = 0; x < 3; ++x) {
        double own = 0, other = 0;
        for (int i = -3; i <= 3; ++i) (x + i < 3 ? own : other) += weights[std::size_t(i + 3)];
        const double expected = share * other / (own + share * other);
        // The light falls straight down, so the lower half is lit from its edge on. Half floats hold 11 bits.
        const int column = kFilterPicture_px / 2 - 3 + x;
        EXPECT_NEAR(double(image[std::size_t(kFilterPicture_px / 2 * kFilterPicture_px + column)]), expected, 0.001)
            << x;
    }
}

TEST(Bilateral, NothingBleedsOverAStep) {
    const Scene scene = quadBeforeRibs();
    // A step of 52 pixels and more at a tolerance of one: weights below exp(-1000).
    EXPECT_EQ(darkestOnQuad(aoOf(scene, kOcclusion)), 1.0f);
    EXPECT_LT(darkestOnQuad(aoOf(scene, kOcclusion + ":plane-tolerance=1000,normal-power=0")), 0.98f);
    EXPECT_EQ(aoOf(scene, kOcclusion + ":radius=0"), aoOf(scene, "ao/blocks:rotation=hash"));
}

}  // namespace
}  // namespace ombrage::test
