// SPDX-License-Identifier: MIT
#include "techniques/ao/sao/own.h"
#include "techniques/step_scene.h"

namespace ombrage::sao {
namespace {

constexpr double kR = test::StepScene::kRadius_m, kH = test::StepScene::kHeight_m;

/// 1 - 5 sigma E[(1 - v.v / r^2)^3 (h - beta) / (v.v + epsilon^2)], sigma one radius, radii even.
double exact(double edge_m) {
    return 1 - test::meanBeyond(
                   edge_m, kR, [](double) { return 1 / kR; },
                   [](double rho) {
                       const double v2 = rho * rho + kH * kH, fall = std::max(0.0, 1 - v2 / (kR * kR));
                       return 5 * kR * fall * fall * fall * (kH - 0.012 * kR) / (v2 + 0.01 * kR * kR);
                   });
}

TEST(Sao, OwnIsItsClosedForm) {
    const auto own = makeIntegrand({});
    // A grid of 256 by 256 cuts the edge to 1/256 of what lies beyond it, with weights of up to 2.5 there.
    for (const double edge_m : {6.0, 9.0, 14.0, 20.0})
        EXPECT_NEAR(test::meanOf(*own, test::stepReceiver(), test::StepProbe(edge_m)), exact(edge_m), 5e-3) << edge_m;
}

TEST(Sao, AFloorBesideAStepHasItsClosedForm) {
    const test::StepScene step;
    // 64 samples on a spiral that is not moved within its rings, each at the middle of its pixel: half a pixel of 24.
    for (const int distance_px : {6, 9, 14, 20}) {
        EXPECT_NEAR(step.before(distance_px, "sao:samples=64,turns=31,mips=false"), exact(distance_px + 0.5), 0.02)
            << distance_px;
        // Coarser depths stand up to two pixels beside the place that is asked for.
        EXPECT_NEAR(step.before(distance_px, "sao:samples=64,turns=31"), exact(distance_px + 0.5), 0.04) << distance_px;
    }
    EXPECT_EQ(test::StepScene(false).before(4, "sao"), 1.0);
}

}  // namespace
}  // namespace ombrage::sao
