// SPDX-License-Identifier: MIT
// A floor in z = 0 seen from above, 64 pixels of 6.25 cm, and plates over it under a sun straight above or slanted.
#include <gtest/gtest.h>
#include <ombrage/error.h>

#include "reference/test_scenes.h"

namespace ombrage::test {
namespace {

constexpr int kSize = 64;
constexpr double kExtent_m = 4, kPixel_m = kExtent_m / kSize;

Scene floorUnder(const glm::vec3& sunDirection) {
    Scene scene;
    add(scene, slab(-10, 10, 10, 0));
    scene.lights = {sun(sunDirection)};
    scene.cameras = {camera({0, 0, 1000}, {0, 0, 0})};
    scene.cameras[0].orthoHeight_m = float(kExtent_m);
    return scene;
}

/// What a scene's features say of points of the floor.
class Probe {
public:
    explicit Probe(const Scene& scene, ReferenceOptions options = picture(kSize, kSize))
        : m_reference(scene),
          m_receivers(m_reference.receivers(scene.cameras[0], options)),
          m_features(m_reference.shadowFeatures(m_receivers, 0, options)) {}

    LightSurroundings around(double x, double y, double reach_m) const {
        return m_features.surroundings({at(x, y)}, {float(reach_m)}).front();
    }
    Blocker blocker(double x, double y) const { return m_features.blockers({at(x, y)}).front(); }
    int layers(double x, double y) const { return m_features.layers({at(x, y)}).front(); }
    float shadingCosine(double x, double y) const { return m_features.shadingCosine[at(x, y)]; }
    const Receivers& receivers() const { return m_receivers; }
    const Reference& reference() const { return m_reference; }

    /// The pixel whose middle is nearest.
    static std::uint32_t at(double x, double y) {
        const int column = int((x + kExtent_m / 2) / kPixel_m), row = int((kExtent_m / 2 - y) / kPixel_m);
        return std::uint32_t(row * kSize + column);
    }

private:
    Reference m_reference;
    Receivers m_receivers;
    ShadowFeatures m_features;
};

TEST(ShadowFeatures, FindTheEdgeThatPassesWithinTheReach) {
    // A plate over x > 0, 1 m up: its shadow's edge is x = 0.
    Scene scene = floorUnder({0, 0, -1});
    add(scene, slab(0, 5, 5, 1));
    scene.cameras[0].position = {0, 0, 0.5};  // under the plate
    const Probe probe(scene);
    // A pixel's middle is 3 cm from x = 0; sunflower points reach to 0.98 of the reach.
    for (const double reach_m : {0.2, 0.4}) {
        for (const double x : {-0.8, -0.5}) {
            EXPECT_TRUE(probe.around(x, 0, reach_m).lit) << x;
            EXPECT_FALSE(probe.around(x, 0, reach_m).shaded) << x;
        }
        for (const double x : {0.5, 0.8}) {
            EXPECT_FALSE(probe.around(x, 0, reach_m).lit) << x;
            EXPECT_TRUE(probe.around(x, 0, reach_m).shaded) << x;
        }
        for (const double x : {-0.1, 0.1}) {
            EXPECT_TRUE(probe.around(x, 0, reach_m).lit) << x;
            EXPECT_TRUE(probe.around(x, 0, reach_m).shaded) << x;
        }
    }
    EXPECT_TRUE(probe.around(-0.3, 0, 0.45).shaded) << "a wide reach gets there";
}

TEST(ShadowFeatures, AWallThatRisesInACreaseIsPartOfTheSurface) {
    // A wall on the floor at x = 0 facing -x, lit by a slanted sun from -x; the solid behind it goes up 1 m.
    Scene scene = floorUnder({1, 0, -1});
    add(scene, shapes::box({0, -5, 0}, {5, 5, 1}));
    const LightSurroundings crease = Probe(scene).around(-0.1, 0, 0.3);
    EXPECT_TRUE(crease.lit);
    EXPECT_FALSE(crease.shaded);
    EXPECT_TRUE(crease.ownCasts);
    // A box afloat, whose shadow begins at x = 0, is a caster of its own.
    Scene afloat = floorUnder({1, 0, -1});
    add(afloat, shapes::box({-1, -5, 1}, {4, 5, 2}));
    afloat.cameras[0].position = {0, 0, 0.5};
    EXPECT_TRUE(Probe(afloat).around(-0.1, 0, 0.3).shaded);
}

TEST(ShadowFeatures, ASlantedFloorIsNotItsOwnCaster) {
    // Light 3 degrees above the floor: the tangent plane rises by 19 times the reach.
    const Scene scene = floorUnder({1, 0, -0.0524f});
    const LightSurroundings around = Probe(scene).around(0.3, 0.2, 0.1);
    EXPECT_TRUE(around.lit);
    EXPECT_FALSE(around.shaded);
}

TEST(ShadowFeatures, KnowWhoCasts) {
    Scene scene = floorUnder({0, 0, -1});
    scene.models[0].casts = false;
    EXPECT_FALSE(Probe(scene).around(0, 0, 0.1).ownCasts);
    // Of itself alone the floor is never shaded.
    scene = floorUnder({0, 0, -1});
    add(scene, slab(-5, 5, 5, 1));
    scene.cameras[0].position = {0, 0, 0.5};
    EXPECT_TRUE(Probe(scene).around(0, 0, 0.1).shaded);
    ReferenceOptions options = picture(kSize, kSize);
    options.kind = TruthKind::Self;
    EXPECT_FALSE(Probe(scene, options).around(0, 0, 0.1).shaded);
    options.kind = TruthKind::Area;
    EXPECT_THROW(Probe(scene, options), Error);
}

TEST(ShadowFeatures, TellTheNearestBlocker) {
    // Over x > 0 a plate 1 m up and another 40 cm up over x > 1, in a sun whose rays rise by 1 m a metre towards +x:
    // from x the lower one begins at x + 0.4 > 1, the upper one at x + 1 > 0.
    Scene scene = floorUnder({-1, 0, -1});
    add(scene, slab(0, 5, 5, 1));
    add(scene, slab(1, 5, 5, 0.4f));
    scene.cameras[0].position = {0, 0, 0.2};
    const Probe probe(scene);
    // 1e-6: the plate's height as a float.
    const auto expect = [](const Blocker& found, std::uint32_t instance, double height_m) {
        EXPECT_EQ(found.instance, instance);
        EXPECT_NEAR(found.distance_m, height_m * std::sqrt(2.0), 1e-6);
    };
    expect(probe.blocker(0.8, 0.3), 2, 0.4);
    expect(probe.blocker(0.3, 0.3), 1, 1);
    expect(probe.blocker(-0.8, 0.3), 1, 1);
    EXPECT_EQ(probe.blocker(-1.3, 0.3).instance, kNoHit);
    EXPECT_EQ(probe.blocker(-1.3, 0.3).distance_m, std::numeric_limits<float>::infinity());

    // Those that cast no shadow block nothing, and of itself alone the floor is free.
    scene.models[2].casts = false;
    expect(Probe(scene).blocker(0.8, 0.3), 1, 1);
    ReferenceOptions options = picture(kSize, kSize);
    options.kind = TruthKind::Self;
    EXPECT_EQ(Probe(scene, options).blocker(0.8, 0.3).instance, kNoHit);

    // A lamp between the plates, above a pixel's middle: only the lower one can be in its way.
    scene.models[2].casts = true;
    scene.lights = {point({1.78125, 0.28125, 0.7})};
    const Probe lamp(scene);
    EXPECT_EQ(lamp.blocker(1.78125, 0.28125).instance, 2u);
    EXPECT_NEAR(lamp.blocker(1.78125, 0.28125).distance_m, 0.4, 1e-6);
    EXPECT_EQ(lamp.blocker(-0.3, 0.3).instance, kNoHit);
}

TEST(ShadowFeatures, CountTheBodiesInTheWay) {
    // A box and a plate over x > 1, the plate alone over 0 to 1.
    Scene scene = floorUnder({0, 0, -1});
    add(scene, slab(0, 5, 5, 2));
    add(scene, shapes::box({1, -5, 0.9f}, {5, 5, 1.5f}));
    scene.cameras[0].position = {0, 0, 0.5};
    const Probe probe(scene);
    // Beside the diagonals, where two triangles of one side meet.
    EXPECT_EQ(probe.layers(-0.5, 0.3), 0);
    EXPECT_EQ(probe.layers(0.5, 0.3), 1);
    EXPECT_EQ(probe.layers(1.5, 0.3), 2) << "a box is one body";
}

TEST(ShadowFeatures, ReachALampAndNoFarther) {
    // A plate behind a lamp shades nothing, whatever the reach.
    Scene scene = floorUnder({0, 0, -1});
    scene.lights = {point({0, 0, 1})};
    add(scene, slab(-5, 5, 5, 1.5f));
    scene.cameras[0].position = {0, 0, 0.5};
    const Probe probe(scene);
    EXPECT_FALSE(probe.around(0.3, 0.2, 0.2).shaded);
    EXPECT_EQ(probe.layers(0.3, 0.2), 0);
    EXPECT_EQ(probe.blocker(0.3, 0.2).instance, kNoHit);
}

TEST(ShadowFeatures, HoldTheShadingCosineAndPositions) {
    const Probe probe(floorUnder({1, 0, -1}));
    EXPECT_NEAR(probe.shadingCosine(0.3, 0.2), std::sqrt(0.5), 1e-6);
    const std::vector<glm::dvec3> positions = probe.reference().positions(probe.receivers());
    const glm::dvec3 p = positions[Probe::at(0.5, -0.5)];
    // Half a pixel and a float's rounding: the pixel that holds the point, not its middle.
    EXPECT_NEAR(p.x, 0.5, kPixel_m / 2 + 1e-6);
    EXPECT_NEAR(p.y, -0.5, kPixel_m / 2 + 1e-6);
    EXPECT_NEAR(p.z, 0, 1e-9);
}

}  // namespace
}  // namespace ombrage::test
