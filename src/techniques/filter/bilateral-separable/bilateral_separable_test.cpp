// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "techniques/filter_scenes.h"

namespace ombrage::test {
namespace {

const std::string kOcclusion = "ao/blocks:rotation=hash+filter/bilateral-separable";

TEST(BilateralSeparable, NothingBleedsOverAStep) {
    const Scene scene = quadBeforeRibs();
    const std::vector<float> raw = aoOf(scene, "ao/blocks:rotation=hash");
    ASSERT_EQ(darkestOnQuad(raw), 1.0f);
    double behind = 0;
    for (const float v : raw) behind += double(1 - v) / double(raw.size());
    ASSERT_GT(behind, 0.05) << "the ribs are meant to be dark";

    // A step of 52 pixels and more at a tolerance of one: weights below exp(-1000).
    EXPECT_EQ(darkestOnQuad(aoOf(scene, kOcclusion)), 1.0f);
    // Without its edge stops the filter is a plain blur, and the quad's rim darkens.
    EXPECT_LT(darkestOnQuad(aoOf(scene, kOcclusion + ":plane-tolerance=1000,normal-power=0")), 0.98f);
}

TEST(BilateralSeparable, RadiusZeroChangesNothing) {
    const Scene scene = quadBeforeRibs();
    EXPECT_EQ(aoOf(scene, kOcclusion + ":radius=0"), aoOf(scene, "ao/blocks:rotation=hash"));
}

TEST(BilateralSeparable, AConstantImageStaysConstantOnSlopesAndSky) {
    Scene scene = emptyScene(kFilterPicture_px);
    // A plane at 80 degrees to the picture, with sky around.
    addQuad(scene, {{-30, -30, -170}, {30, -30, -170}, {30, 30, 170}, {-30, 30, 170}}, 0.1f);
    for (const float v : aoOf(scene, "ao/none+filter/bilateral-separable")) ASSERT_EQ(v, 1.0f);
}

TEST(BilateralSeparable, NoiseFallsOnASlope) {
    const std::string noisy = "ao/blocks:samples=16,rotation=hash";
    const double before = roughnessOfSlope(noisy);
    ASSERT_GT(before, 0.1);
    // A Gaussian of sigma 2 along the column leaves a few percent of white noise's second differences; a difference of
    // depths with the same tolerance would leave nearly all.
    EXPECT_LT(roughnessOfSlope(noisy + "+filter/bilateral-separable"), 0.35 * before);
}

}  // namespace
}  // namespace ombrage::test
