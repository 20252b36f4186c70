// SPDX-License-Identifier: MIT
#include "techniques/shared/near_clip.h"

#include <random>

#include <gtest/gtest.h>

#include "render_fixture.h"

namespace ombrage {
namespace {

using hand::viewAhead;  // its near plane's rectangle is 4 cm by 2 cm in perspective
/// Half the side of the boxes that are tried: small beside the volumes' cross sections.
constexpr float kHalfBox_m = 1e-4f;

bool touches(const NearClipVolume& volume, const glm::vec3& center) {
    return volume.touches(center - kHalfBox_m, center + kHalfBox_m);
}

/// The volume's cross section at the depth z is `half` wide and high about `center`: boxes 5 % inside of its sides are
/// found and boxes 5 % outside are not. The rectangle is taken 2 % larger, which lies between.
void expectSection(const NearClipVolume& volume, const glm::vec3& center, const glm::vec2& half) {
    EXPECT_TRUE(touches(volume, center));
    for (const float side : {-1.0f, 1.0f}) {
        EXPECT_TRUE(touches(volume, center + glm::vec3(0.95f * side * half.x, 0, 0))) << side;
        EXPECT_TRUE(touches(volume, center + glm::vec3(0, 0.95f * side * half.y, 0))) << side;
        EXPECT_FALSE(touches(volume, center + glm::vec3(1.05f * side * half.x, 0, 0))) << side;
        EXPECT_FALSE(touches(volume, center + glm::vec3(0, 1.05f * side * half.y, 0))) << side;
    }
}

TEST(NearClip, ALampBeforeTheNearPlaneMakesAPyramid) {
    const NearClipVolume volume(viewAhead(), {0, 0, -2.01, 1});
    expectSection(volume, {0, 0, -1.01f}, {0.01f, 0.005f});  // half way: half of the rectangle
    expectSection(volume, {0, 0, -0.51f}, {0.015f, 0.0075f});
    EXPECT_FALSE(touches(volume, {0, 0, -2.1f})) << "behind the lamp";
    EXPECT_FALSE(volume.touches({-5, -5, -2.2f}, {5, 5, -2.1f})) << "a wall behind the lamp";
    EXPECT_FALSE(touches(volume, {0, 0, -0.005f})) << "between the eye and the near plane";
    EXPECT_FALSE(touches(volume, {0, 0, 0.5f})) << "behind the eye";
    EXPECT_TRUE(volume.touches({-5, -5, -5}, {5, 5, 5})) << "around everything";
    EXPECT_TRUE(volume.touches({-5, -5, -1.02f}, {5, 5, -1})) << "across the pyramid";
}

TEST(NearClip, ALampBehindTheEyeIsShadedFromBehind) {
    const NearClipVolume volume(viewAhead(), {0, 0, 1.99, 1});
    expectSection(volume, {0, 0, 0.99f}, {0.01f, 0.005f});
    EXPECT_TRUE(touches(volume, {0, 0, 0.001f})) << "at the eye";
    EXPECT_FALSE(touches(volume, {0, 0, -0.5f})) << "before the near plane";
    EXPECT_FALSE(touches(volume, {0, 0, 2.5f})) << "behind the lamp";
}

TEST(NearClip, ALampAsideSlantsThePyramid) {
    const NearClipVolume volume(viewAhead(), {1, 0.5, -2.01, 1});
    expectSection(volume, {0.5f, 0.25f, -1.01f}, {0.01f, 0.005f});
    EXPECT_FALSE(touches(volume, {0, 0, -1.01f}));
    EXPECT_FALSE(touches(volume, {1.5f, 0.75f, -3.01f})) << "behind the lamp";
}

TEST(NearClip, ASunMakesAPrism) {
    const NearClipVolume ahead(viewAhead(), {0, 0, -1, 0});
    for (const float z : {-0.1f, -1.0f, -50.0f}) expectSection(ahead, {0, 0, z}, {0.02f, 0.01f});
    EXPECT_FALSE(touches(ahead, {0, 0, 0.5f})) << "behind the eye";

    const NearClipVolume behind(viewAhead(), {0, 0, 1, 0});
    expectSection(behind, {0, 0, 5}, {0.02f, 0.01f});
    EXPECT_FALSE(touches(behind, {0, 0, -0.5f})) << "before the near plane";

    const NearClipVolume aside(viewAhead(), {1, 0.5, -1, 0});
    expectSection(aside, {1, 0.5f, -1.01f}, {0.02f, 0.01f});
    EXPECT_FALSE(touches(aside, {0, 0, -1.01f}));
    EXPECT_FALSE(touches(aside, {-1, -0.5f, 0.99f})) << "away from the sun";
}

TEST(NearClip, AnOrthographicRectangleIsThePictures) {
    const NearClipVolume lamp(viewAhead(2.0f), {0, 0, -4.01, 1});
    expectSection(lamp, {0, 0, -2.01f}, {1, 0.5f});
    EXPECT_FALSE(touches(lamp, {0, 0, -4.5f})) << "behind the lamp";
    EXPECT_FALSE(touches(lamp, {0, 0, 0.5f})) << "behind the eye";
    const NearClipVolume sun(viewAhead(2.0f), {1, 0, -1, 0});
    expectSection(sun, {3, 0, -3.01f}, {2, 1});
    EXPECT_FALSE(touches(sun, {-1, 0, 0.99f})) << "away from the sun";
}

TEST(NearClip, ALightWithinTheNearPlaneRulesNothingOut) {
    for (const glm::vec4& toward : {glm::vec4(0, 1, 0, 0), glm::vec4(3, 0, -0.01, 1)}) {
        const NearClipVolume volume(viewAhead(), toward);
        for (const glm::vec3& p : {glm::vec3(0, 0, 5), glm::vec3(0, 0, -5), glm::vec3(5, 5, 0)})
            EXPECT_TRUE(touches(volume, p));
    }
}

TEST(NearClip, MissesNoPointOnAWayToTheLight) {
    std::mt19937 random(7);
    const auto within = [&](double low, double high) { return std::uniform_real_distribution<>(low, high)(random); };
    const auto direction = [&] { return glm::dvec3(within(-1, 1), within(-1, 1), within(-1, 1)); };
    for (int i = 0; i < 2000; ++i) {
        Camera camera;
        camera.position = 5.0 * direction();
        camera.target = camera.position + direction();
        if (i % 4 >= 2) camera.orthoHeight_m = 3.0f;
        const CameraView view = makeCameraView(camera, 400, 200, glm::dvec3(0), {glm::vec3(-100), glm::vec3(100)});
        const glm::dvec4 toward(4.0 * direction(), i % 2);

        // A point of the near rectangle, and one on its way to the light.
        glm::dvec3 start, along;
        view.ray(within(0, 400), within(0, 200), start, along);
        const glm::dvec3 onNear = start + along * (double(view.near_m) / glm::dot(along, glm::dvec3(view.forward)));
        const glm::dvec3 p = onNear + within(0, 1) * (glm::dvec3(toward) - onNear * toward.w);
        EXPECT_TRUE(touches(NearClipVolume(view, glm::vec4(toward)), glm::vec3(p))) << i;
    }
}

}  // namespace
}  // namespace ombrage
