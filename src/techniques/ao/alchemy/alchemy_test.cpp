// SPDX-License-Identifier: MIT
#include "techniques/ao/alchemy/own.h"
#include "techniques/step_scene.h"

namespace ombrage::alchemy {
namespace {

constexpr double kR = test::StepScene::kRadius_m, kH = test::StepScene::kHeight_m;

/// 1 - 2 sigma E[h / (rho^2 + h^2 + epsilon^2)], sigma half a radius, epsilon a hundredth of it.
double exact(double edge_m) {
    return 1 - test::meanBeyond(
                   edge_m, kR, [](double rho) { return 2 * rho / (kR * kR); },
                   [](double rho) { return kR * kH / (rho * rho + kH * kH + 1e-4 * kR * kR); });
}

TEST(Alchemy, ItsClosedFormIsThatOfTheHalfDisk) {
    // At the foot of the step: sigma h / r^2 ln(1 + r^2 / (h^2 + epsilon^2)), sigma = r / 2.
    const double foot = 1 - 0.5 * kH / kR * std::log((kR * kR + kH * kH + 1e-4 * kR * kR) / (kH * kH + 1e-4 * kR * kR));
    EXPECT_NEAR(exact(0), foot, 1e-4);  // the midpoint rule's error
}

TEST(Alchemy, OwnIsItsClosedForm) {
    const auto own = makeIntegrand({});
    // A grid of 256 by 256 cuts the edge to 1/256 of what lies beyond it.
    for (const double edge_m : {0.0, 2.0, 8.0, 20.0})
        EXPECT_NEAR(test::meanOf(*own, test::stepReceiver(), test::StepProbe(edge_m)), exact(edge_m), 2e-3) << edge_m;
    // A contrast is the power of the mean.
    AlchemyParams params;
    params.contrast = 2;
    EXPECT_NEAR(test::meanOf(*makeIntegrand(params), test::stepReceiver(), test::StepProbe(2), 16), exact(2) * exact(2),
                0.01);  // 64 points
}

TEST(Alchemy, AFloorBesideAStepHasItsClosedForm) {
    const test::StepScene step;
    // 64 samples; pixels move each to their middle, half a pixel of 24 at most; halves hold 11 bits.
    for (const int distance_px : {0, 2, 8, 20})
        EXPECT_NEAR(step.before(distance_px, "alchemy:samples=64"), exact(distance_px + 0.5), 0.01) << distance_px;
    EXPECT_EQ(test::StepScene(false).before(4, "alchemy"), 1.0);
}

TEST(Alchemy, ABentNormalDoesNotMakeTheSurfaceOccludeItself) {
    AoReceiver receiver = test::stepReceiver();
    receiver.shadingNormal = glm::normalize(glm::dvec3(0.6, 0, 0.8));
    // Of the directions about n_s the share (1 - n_s.n_g) / 2 is below the plane; nothing else is there.
    EXPECT_NEAR(test::meanOf(*makeIntegrand({}), receiver, test::StepProbe(1e9), 64), 0.9, 1e-9);
}

}  // namespace
}  // namespace ombrage::alchemy
