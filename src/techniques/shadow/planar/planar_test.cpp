// SPDX-License-Identifier: MIT
// Known answers on a wall of 32 x 32 m in z = 0, seen straight on: a metre is a pixel. A lamp 4 m before it throws the
// shadow of what is at height z to 4 / (4 - z) times its place.
#include <algorithm>

#include <gtest/gtest.h>
#include <ombrage/error.h>

#include "techniques/flat_scene_picture.h"

namespace ombrage::test {
namespace {

constexpr int kSize = 32;

Scene wallAndLamp() {
    Scene scene = emptyScene(kSize);
    addQuad(scene, {{-16, -16, 0}, {16, -16, 0}, {16, 16, 0}, {-16, 16, 0}}, 0.5f);
    scene.lights[0].type = LightType::Point;
    scene.lights[0].position = {0, 0, 4};
    scene.lights[0].intensity = 100;
    return scene;
}

/// x from 1 to 2, y from -1 to 1; its height goes from `near_m` at x = 1 to `far_m` at x = 2.
void addCaster(Scene& scene, float near_m, float far_m) {
    addQuad(scene, {{1, -1, near_m}, {2, -1, far_m}, {2, 1, far_m}, {1, 1, near_m}}, 0.2f);
}

class Wall {
public:
    explicit Wall(const Scene& scene, const std::string& technique = "shadow/planar") {
        RenderSettings settings = squareSettings(kSize);
        settings.shadow = parsePipeline(Family::Shadow, technique);
        const RenderResult result = renderFlat(scene, settings);
        const auto plane = result.visibility.begin()->second.plane(0);
        m_visibility.assign(plane.begin(), plane.end());
    }
    /// At the pixel that holds the point of the wall.
    float at(float x, float y) const {
        return m_visibility[std::size_t((16 - y) * 1.0f) * kSize + std::size_t(x + 16)];
    }
    int countBelow(float bound) const {
        return int(std::count_if(m_visibility.begin(), m_visibility.end(), [&](float v) { return v < bound; }));
    }

private:
    std::vector<float> m_visibility;
};

TEST(ShadowPlanar, ALampsShadowIsTheProjection) {
    Scene scene = wallAndLamp();
    addCaster(scene, 2, 2);
    const Wall wall(scene);
    // Twice as large: x from 2 to 4, y from -2 to 2.
    EXPECT_EQ(wall.countBelow(0.5f), 8);
    for (const float x : {2.5f, 3.5f})
        for (const float y : {-1.5f, -0.5f, 0.5f, 1.5f}) EXPECT_EQ(wall.at(x, y), 0.0f) << x << " " << y;
}

TEST(ShadowPlanar, ASunsShadowIsAShift) {
    Scene scene = wallAndLamp();
    scene.lights[0].type = LightType::Sun;
    scene.lights[0].direction = glm::normalize(glm::vec3(2, 0, -1));
    addCaster(scene, 2, 2);
    const Wall wall(scene);
    // 4 m to the right: x from 5 to 6.
    EXPECT_EQ(wall.countBelow(0.5f), 2);
    EXPECT_EQ(wall.at(5.5f, 0.5f), 0.0f);
    EXPECT_EQ(wall.at(5.5f, -0.5f), 0.0f);
}

// Projected through the lamp, a caster behind it would darken x from -4 to -2.
TEST(ShadowPlanar, WhatIsBehindTheLightThrowsNoAntiShadow) {
    Scene scene = wallAndLamp();
    addCaster(scene, 6, 6);
    EXPECT_EQ(Wall(scene).countBelow(0.5f), 0);
}

TEST(ShadowPlanar, ACasterThatReachesOverTheLightIsCutThere) {
    Scene scene = wallAndLamp();
    addCaster(scene, 2, 6);
    const Wall wall(scene);
    // From x = 2 to infinity, ever wider: at x = 14.5 the caster is 3.58 m high, so y reaches 9.5.
    EXPECT_EQ(wall.at(14.5f, 8.5f), 0.0f);
    EXPECT_EQ(wall.at(14.5f, 10.5f), 1.0f);
    for (float x = -15.5f; x < 0; ++x)
        for (float y = -15.5f; y < 16; ++y) EXPECT_EQ(wall.at(x, y), 1.0f) << x << " " << y;
}

TEST(ShadowPlanar, WhatIsUnderThePlaneThrowsNoShadow) {
    Scene scene = wallAndLamp();
    addCaster(scene, -2, -2);
    EXPECT_EQ(Wall(scene).countBelow(0.5f), 0);
    // Half of it under the plane: its upper part alone, up to x = 1.5 in the plane.
    Scene half = wallAndLamp();
    addCaster(half, 2, -2);
    const Wall wall(half);
    EXPECT_EQ(wall.at(1.5f, 3.5f), 1.0f);
    EXPECT_EQ(wall.at(3.5f, 0.5f), 1.0f);
}

TEST(ShadowPlanar, ShadowsOverEachOtherDarkenOnce) {
    Scene scene = wallAndLamp();
    addCaster(scene, 2, 2);
    addCaster(scene, 2.2f, 2.2f);
    const Wall wall(scene, "shadow/planar:opacity=0.5");
    EXPECT_GT(wall.countBelow(0.6f), 0);
    EXPECT_EQ(wall.countBelow(0.49f), 0);
}

TEST(ShadowPlanar, AGivenPlaneTakesThePlaceOfThoseFound) {
    Scene scene = wallAndLamp();
    addCaster(scene, 2, 2);
    const std::string given = "shadow/planar:receivers=given,normal=(0;0;0.5),offset=";
    EXPECT_EQ(Wall(scene, given + "0").countBelow(0.5f), 8);
    EXPECT_EQ(Wall(scene, given + "1").countBelow(0.5f), 0);
    EXPECT_THROW(Wall(scene, "shadow/planar:receivers=given,normal=(0;0;0)"), Error);
}

TEST(ShadowPlanar, WhatLiesInThePlaneIsNoCaster) {
    Scene scene = wallAndLamp();
    addCaster(scene, 0, 0);
    EXPECT_EQ(Wall(scene).countBelow(0.5f), 0);
}

}  // namespace
}  // namespace ombrage::test
