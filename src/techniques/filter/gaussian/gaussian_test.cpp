// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "techniques/filter_scenes.h"

namespace ombrage::test {
namespace {

TEST(Gaussian, OnePixelBecomesTheKernel) {
    const auto weights = gaussianWeights(5, 2.5);
    const ImpulseResponse response("filter/gaussian:radius=5,sigma=2.5");
    double sum = 0;
    for (int dy = -6; dy <= 6; ++dy)
        for (int dx = -6; dx <= 6; ++dx) {
            const bool isInside = std::abs(dx) <= 5 && std::abs(dy) <= 5;
            const double expected = isInside ? weights[std::size_t(dx + 5)] * weights[std::size_t(dy + 5)] : 0.0;
            // Two passes to half floats of 11 bits, which drivers may round down: 2^-10 each.
            EXPECT_NEAR(response.at(dx, dy), expected, expected * 0.002) << dx << " " << dy;
            sum += response.at(dx, dy);
        }
    EXPECT_NEAR(sum, 1.0, 0.001);
}

TEST(Gaussian, WhatLiesOutsideOfThePictureHasNoWeight) {
    // The leftmost column alone is lit. In it the weights to the left are missing, and the rest is normalised.
    const int half = kFilterPicture_px / 2;
    const std::vector<float> image =
        filteredShadow(lightThroughHole(float(-half), float(1 - half), -60, 60), "filter/gaussian:radius=4,sigma=2");
    const auto weights = gaussianWeights(4, 2);
    double inside = 0;
    for (int i = 0; i <= 4; ++i) inside += weights[std::size_t(4 + i)];
    EXPECT_NEAR(double(image[std::size_t(half * kFilterPicture_px)]), weights[4] / inside, 0.001);
    // It does not stop at edges, which is what it is for.
    EXPECT_LT(darkestOnQuad(aoOf(quadBeforeRibs(), "ao/blocks:rotation=hash+filter/gaussian")), 0.98f);
}

TEST(Gaussian, RadiusZeroChangesNothing) {
    const Scene scene = quadBeforeRibs();
    EXPECT_EQ(aoOf(scene, "ao/blocks:rotation=hash+filter/gaussian:radius=0"), aoOf(scene, "ao/blocks:rotation=hash"));
}

}  // namespace
}  // namespace ombrage::test
