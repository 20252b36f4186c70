// SPDX-License-Identifier: MIT
#include <algorithm>

#include "techniques/ao/hbao/own.h"
#include "techniques/step_scene.h"

namespace ombrage::hbao {
namespace {

constexpr double kR = test::StepScene::kRadius_m, kH = test::StepScene::kHeight_m, kPi = 3.14159265358979323846;

/// In the direction theta the edge lies at s = edge / cos theta: sin h = H / sqrt(s^2 + H^2), attenuated by that
/// distance.
double exact(double edge_m, double bias_rad) {
    const double occlusion = test::integral(0, 0.5 * kPi, [&](double theta) {
        const double distance_m = std::hypot(edge_m / std::cos(theta), kH);
        return std::max(0.0, 1 - distance_m * distance_m / (kR * kR)) *
               std::max(0.0, kH / distance_m - std::sin(bias_rad));
    });
    return 1 - occlusion / kPi;
}

HbaoParams biased(double bias_rad) {
    HbaoParams params;
    params.angleBias_rad = float(bias_rad);
    return params;
}

TEST(Hbao, ItsClosedFormIsHalfAtTheFoot) {
    EXPECT_NEAR(exact(0, 0), 0.5 + 0.5 * kH * kH / (kR * kR), 1e-6);
}

TEST(Hbao, OwnIsItsClosedForm) {
    // A step of 1/24 finds the edge half a metre late on the average; that lowers sin h by up to 0.06 close to it.
    for (const double edge_m : {1.0, 4.0, 10.0, 20.0})
        for (const double bias_rad : {0.0, kPi / 6})
            EXPECT_NEAR(test::meanOf(*makeIntegrand(biased(bias_rad)), test::stepReceiver(), test::StepProbe(edge_m)),
                        exact(edge_m, bias_rad), 0.02)
                << edge_m;
}

TEST(Hbao, AFloorBesideAStepHasItsClosedForm) {
    const test::StepScene step;
    // Steps of half a pixel; the surface is that of a pixel's middle.
    for (const int distance_px : {4, 10, 20})
        EXPECT_NEAR(step.before(distance_px, "hbao:directions=32,steps=48,angle-bias=0"), exact(distance_px + 0.5, 0),
                    0.015)
            << distance_px;
    EXPECT_EQ(test::StepScene(false).before(4, "hbao:angle-bias=0"), 1.0);
}

TEST(Hbao, ABentNormalDoesNotMakeTheSurfaceOccludeItself) {
    AoReceiver receiver = test::stepReceiver();
    receiver.shadingNormal = glm::normalize(glm::dvec3(0.6, 0, 0.8));
    // Of the directions about n_s the share (1 - n_s.n_g) / 2 is below the plane; nothing else is there.
    EXPECT_NEAR(test::meanOf(*makeIntegrand(biased(0)), receiver, test::StepProbe(1e9), 64), 0.9, 1e-9);
}

}  // namespace
}  // namespace ombrage::hbao
