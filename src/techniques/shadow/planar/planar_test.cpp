// SPDX-License-Identifier: MIT
// Known answers: where shadows fall, and what each rule of the method keeps away.
#include <gtest/gtest.h>
#include <ombrage/error.h>

#include "techniques/shadow/planar/wall_fixture.h"

namespace ombrage::test {
namespace {

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

// One triangle after the other: where two quads lie over each other the light is halved twice, elsewhere once.
TEST(ShadowPlanar, WithoutStencilShadowsOverEachOtherDarkenTwice) {
    Scene scene = wallAndFarLamp();
    addFarCaster(scene, 1, 3, -1, 1);
    addFarCaster(scene, 2, 4, -1, 1);
    const Wall once(scene, "shadow/planar:opacity=0.5"), twice(scene, "shadow/planar:opacity=0.5,stencil=false");
    for (const float y : {-1.5f, 0.5f}) {
        for (const float x : {2.5f, 4.5f, 6.5f}) EXPECT_EQ(once.at(x, y), 0.5f) << x;
        EXPECT_EQ(twice.at(2.5f, y), 0.5f);
        EXPECT_EQ(twice.at(4.5f, y), 0.25f);
        EXPECT_EQ(twice.at(6.5f, y), 0.5f);
    }
    // 6 x 4 m in all, of which 2 x 4 are covered twice.
    EXPECT_EQ(once.countBelow(0.6f), 24);
    EXPECT_EQ(once.countBelow(0.4f), 0);
    EXPECT_EQ(twice.countBelow(0.6f), 24);
    EXPECT_EQ(twice.countBelow(0.4f), 8);
}

TEST(ShadowPlanar, WithoutLimitTheShadowReachesOverTheEdgeAndOnWhatLiesBehind) {
    Scene scene = wallAndFarLamp();
    scene.meshes[0].positions = {{-3, -3, 0}, {3, -3, 0}, {3, 3, 0}, {-3, 3, 0}};
    addQuad(scene, {{0, -16, -2}, {4, -16, -2}, {4, 16, -2}, {0, 16, -2}}, 0.5f);
    // Its shadow on z = 0: x from 2 to 6, y from -2 to 2, of which the wall holds x up to 3.
    addFarCaster(scene, 1, 3, -1, 1);
    for (Model& model : scene.models) model.receives = false;
    scene.models[0].receives = true;
    const Wall limited(scene), unlimited(scene, "shadow/planar:limit=false");
    for (const float y : {-1.5f, 0.5f}) {
        EXPECT_EQ(limited.at(2.5f, y), 0.0f);
        // On the strip behind, and beyond it before nothing.
        for (const float x : {3.5f, 5.5f}) {
            EXPECT_EQ(limited.at(x, y), 1.0f) << x;
            EXPECT_EQ(unlimited.at(x, y), 0.0f) << x;
        }
    }
    EXPECT_EQ(limited.countBelow(0.5f), 4);
    EXPECT_EQ(unlimited.countBelow(0.5f), 16);
}

// S = L + a (V - L) with a = 4 / (4 - 6): through the lamp, twice as large.
TEST(ShadowPlanar, WithoutItsClipWhatIsBehindTheLightThrowsAnAntiShadow) {
    Scene scene = wallAndLamp();
    addCaster(scene, 6, 6);
    const Wall wall(scene, "shadow/planar:clip-light=false");
    EXPECT_EQ(wall.countBelow(0.5f), 8);
    for (const float x : {-3.5f, -2.5f})
        for (const float y : {-1.5f, 1.5f}) EXPECT_EQ(wall.at(x, y), 0.0f) << x << " " << y;
    // A sun has nothing behind it.
    scene.lights[0].type = LightType::Sun;
    scene.lights[0].direction = {0, 0, -1};
    EXPECT_EQ(Wall(scene, "shadow/planar:clip-light=false").countBelow(0.5f), Wall(scene).countBelow(0.5f));
}

// a = 4 / (4 + 1): from x = 0.8 to 1.6, y from -0.8 to 0.8, in which two pixels have their middle.
TEST(ShadowPlanar, WithoutItsClipWhatIsUnderThePlaneShadesIt) {
    Scene scene = wallAndLamp();
    addCaster(scene, -1, -1);
    EXPECT_EQ(Wall(scene).countBelow(0.5f), 0);
    const Wall wall(scene, "shadow/planar:clip-plane=false");
    EXPECT_EQ(wall.countBelow(0.5f), 2);
    EXPECT_EQ(wall.at(1.5f, 0.5f), 0.0f);
    // What lies in the plane, as the wall itself, throws none even so.
    EXPECT_EQ(Wall(wallAndLamp(), "shadow/planar:clip-plane=false").countBelow(0.5f), 0);
}

/// The wall in white under the lamp, with a caster of one colour; the share of the light that its shadow leaves.
glm::vec3 shareInShadow(const std::string& technique, Composite composite = Composite::Lighting) {
    Scene scene = wallAndLamp();
    scene.materials[0].baseColor = glm::vec3(1);
    scene.materials[0].emissive = glm::vec3(0);
    addCaster(scene, 2, 2);
    scene.materials[1].baseColor = {0.25f, 0.5f, 1};
    const Wall shadowed(scene, technique, composite), open(scene, "shadow/none");
    // The pixel's own light, so that its distance and its angle cancel out.
    return shadowed.colorAt(2.5f, 0.5f) / open.colorAt(2.5f, 0.5f);
}

TEST(ShadowPlanar, ATintColoursTheLightThatPasses) {
    const auto expectNear = [](const glm::vec3& a, const glm::vec3& b) {
        // Half floats hold 11 bits, the G-buffer's albedo 10.
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], 0.004f) << c;
    };
    expectNear(shareInShadow("shadow/planar"), glm::vec3(0));
    expectNear(shareInShadow("shadow/planar:opacity=0.75"), glm::vec3(0.25f));
    const glm::vec3 tint(0.5f, 0, 1);
    const std::string tinted = "shadow/planar:style=tinted,tint=(0.5;0;1)";
    expectNear(shareInShadow(tinted), tint);
    expectNear(shareInShadow(tinted + ",opacity=0.5"), 0.5f + 0.5f * tint);
    expectNear(shareInShadow(tinted, Composite::Modulate), tint);
    expectNear(shareInShadow("shadow/planar:style=textured"), {0.25f, 0.5f, 1});
    // A filter after it knows one channel.
    expectNear(shareInShadow(tinted + "+filter/none"), glm::vec3(0.5f * 0.2126f + 0.0722f));
}

TEST(ShadowPlanar, WhatPassesIsMeasuredByItsLuminance) {
    Scene scene = wallAndLamp();
    addCaster(scene, 2, 2);
    const Wall tinted(scene, "shadow/planar:style=tinted,tint=(0.5;0;1)");
    EXPECT_NEAR(tinted.at(2.5f, 0.5f), 0.5f * 0.2126f + 0.0722f, 0.001f);
    EXPECT_EQ(tinted.at(5.5f, 0.5f), 1.0f);
    EXPECT_EQ(tinted.countBelow(0.9f), 8);
}

TEST(ShadowPlanar, HatchesAreStripesOfTheirWidth) {
    Scene scene = wallAndFarLamp();
    addFarCaster(scene, -7, 7, -7, 7);
    // Diagonal, 8 sqrt(2) m apart: along a row 16 pixels from hatch to hatch, 8 of them dark.
    const Wall wall(scene, "shadow/planar:style=hatched,hatch=11.3137085");
    for (const float y : {-5.5f, 0.5f, 5.5f}) {
        int dark = 0, turns = 0;
        for (float x = -13.5f; x < 2; ++x) {
            dark += wall.at(x, y) < 0.5f ? 1 : 0;
            turns += (wall.at(x, y) < 0.5f) != (wall.at(x + 1, y) < 0.5f) ? 1 : 0;
        }
        EXPECT_NEAR(dark, 8, 1) << y;
        EXPECT_EQ(turns, 2) << y;
    }
    // Every hatch has its place on the plane: along the diagonal nothing changes.
    const bool rises = wall.at(0.5f, 0.5f) == wall.at(1.5f, 1.5f) && wall.at(3.5f, 0.5f) == wall.at(4.5f, 1.5f);
    const float down = rises ? 1.0f : -1.0f;
    for (float d = 1; d < 8; ++d) EXPECT_EQ(wall.at(0.5f + d, 0.5f + down * d), wall.at(0.5f, 0.5f)) << d;
}

TEST(ShadowPlanar, StagesShowWhatTheyName) {
    Scene scene = wallAndFarLamp();
    scene.meshes[0].positions = {{-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0}};
    addFarCaster(scene, 1, 3, -1, 1);
    // Half as high: its shadow, 4/3 as large, goes from -4 to -1.33.
    addQuad(scene, {{-3, -3, 10.5f}, {-1, -3, 10.5f}, {-1, 3, 10.5f}, {-3, 3, 10.5f}}, 0.2f);
    for (Model& model : scene.models) model.receives = false;
    scene.models[0].receives = true;
    RenderSettings settings = squareSettings(kSize);
    settings.shadow = parsePipeline(Family::Shadow, "shadow/planar:opacity=0.75");
    settings.show = {"planar-limit", "planar-projected", "planar-heights", "planar-passed"};
    const RenderResult result = renderFlat(scene, settings);
    const auto at = [&](const char* name, float x, float y) {
        return result.shownRaw.at(name).plane(0)[std::size_t(16 - y) * kSize + std::size_t(x + 16)];
    };
    EXPECT_EQ(at("planar-limit", 3.5f, 3.5f), 1.0f);
    EXPECT_EQ(at("planar-limit", 4.5f, 3.5f), 0.0f);
    // Two triangles, and where nothing limits them beyond the wall's edge, too.
    for (const float x : {2.5f, 5.5f}) EXPECT_NEAR(at("planar-projected", x, 0.5f), 1.0f / 6, 0.001f) << x;
    EXPECT_EQ(at("planar-projected", 0.5f, 0.5f), 0.0f);
    EXPECT_NEAR(at("planar-heights", 2.5f, 0.5f), 1.0f, 0.001f);
    EXPECT_NEAR(at("planar-heights", -2.5f, 0.5f), 0.525f, 0.001f);
    EXPECT_EQ(at("planar-heights", 0.5f, 0.5f), 0.0f);
    EXPECT_NEAR(at("planar-passed", 2.5f, 0.5f), 0.25f, 0.001f);
    EXPECT_EQ(at("planar-passed", 0.5f, 0.5f), 1.0f);
}

}  // namespace
}  // namespace ombrage::test
