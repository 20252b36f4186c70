// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>
#include <ombrage/renderer.h>

#include "techniques/flat_scene_picture.h"

namespace ombrage::test {
namespace {

constexpr int kSize = 96;

/// A dark trench far behind an open quad of 32x32 pixels: the wall at z = -60 carries ribs, so its occlusion is strong
/// right around the quad's outline, while nothing lies within reach of the quad.
Scene quadBeforeRibs() {
    Scene scene = emptyScene(kSize);
    const float r = kSize;
    addQuad(scene, {{-r, -r, -60}, {r, -r, -60}, {r, r, -60}, {-r, r, -60}}, 0.1f);
    for (int x = -46; x <= 46; x += 4) {
        const float at = float(x);
        addQuad(scene, {{at, -r, -52}, {at + 2, -r, -60}, {at + 2, r, -60}, {at, r, -52}}, 0.1f);
    }
    addQuad(scene, {{-16, -16, 0}, {16, -16, 0}, {16, 16, 0}, {-16, 16, 0}}, 0.1f);
    return scene;
}

std::vector<float> aoOf(const Scene& scene, const std::string& pipeline) {
    RenderSettings settings = squareSettings(kSize);
    settings.ao = parsePipeline(Family::Ao, pipeline);
    const RenderResult result = renderFlat(scene, settings);
    return {result.ao->plane(0).begin(), result.ao->plane(0).end()};
}

bool isQuad(std::size_t i) {
    const int x = int(i) % kSize - kSize / 2, y = int(i) / kSize - kSize / 2;
    return x >= -16 && x < 16 && y >= -16 && y < 16;
}

/// Darkest value on the quad.
float darkest(const std::vector<float>& image) {
    float value = 1;
    for (std::size_t i = 0; i < image.size(); ++i)
        if (isQuad(i)) value = std::min(value, image[i]);
    return value;
}

const std::string kOcclusion = "ao/blocks:rotation=hash+filter/bilateral-separable";

TEST(BilateralSeparable, NothingBleedsOverAStep) {
    const Scene scene = quadBeforeRibs();
    const std::vector<float> raw = aoOf(scene, "ao/blocks:rotation=hash");
    ASSERT_EQ(darkest(raw), 1.0f);
    double behind = 0;
    for (std::size_t i = 0; i < raw.size(); ++i) behind += isQuad(i) ? 0 : double(1 - raw[i]) / (kSize * kSize);
    ASSERT_GT(behind, 0.05) << "the ribs are meant to be dark";

    // A step of 52 pixels and more at a tolerance of one: weights below exp(-1000).
    EXPECT_EQ(darkest(aoOf(scene, kOcclusion)), 1.0f);
    // Without its edge stops the filter is a plain blur, and the quad's rim darkens.
    EXPECT_LT(darkest(aoOf(scene, kOcclusion + ":plane-tolerance=1000,normal-power=0")), 0.98f);
}

TEST(BilateralSeparable, RadiusZeroChangesNothing) {
    const Scene scene = quadBeforeRibs();
    EXPECT_EQ(aoOf(scene, kOcclusion + ":radius=0"), aoOf(scene, "ao/blocks:rotation=hash"));
}

TEST(BilateralSeparable, AConstantImageStaysConstantOnSlopesAndSky) {
    Scene scene = emptyScene(kSize);
    // A plane at 80 degrees to the picture, with sky around.
    addQuad(scene, {{-30, -30, -170}, {30, -30, -170}, {30, 30, 170}, {-30, 30, 170}}, 0.1f);
    for (const float v : aoOf(scene, "ao/none+filter/bilateral-separable")) ASSERT_EQ(v, 1.0f);
}

TEST(BilateralSeparable, NoiseFallsOnASlope) {
    // Noise beside a wall that leans away, on a slope of 80 degrees: the tangent plane lets the blur work although
    // depth changes by 6 pixels from row to row.
    Scene scene = emptyScene(kSize);
    addQuad(scene, {{-48, -40, -540}, {48, -40, -540}, {48, 40, -60}, {-48, 40, -60}}, 0.1f);
    addQuad(scene, {{0, -40, -540}, {0, 40, -60}, {-20, 0.6f, -53.4f}, {-20, -79.4f, -533.4f}}, 0.1f);
    const auto roughness = [](const std::vector<float>& image) {
        double sum = 0;
        for (int y = 20; y < kSize - 20; ++y)
            for (int x = 50; x < 54; ++x) {
                const std::size_t i = std::size_t(y * kSize + x);
                const double bend = double(image[i - kSize]) - 2 * double(image[i]) + double(image[i + kSize]);
                sum += bend * bend;
            }
        return std::sqrt(sum);
    };
    const std::string noisy = "ao/blocks:samples=16,rotation=hash";
    const double before = roughness(aoOf(scene, noisy));
    ASSERT_GT(before, 0.1);
    // A Gaussian of sigma 2 along the column leaves a few percent of white noise's second differences; a difference of
    // depths with the same tolerance would leave nearly all.
    EXPECT_LT(roughness(aoOf(scene, noisy + "+filter/bilateral-separable")), 0.35 * before);
}

}  // namespace
}  // namespace ombrage::test
