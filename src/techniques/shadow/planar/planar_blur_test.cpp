// SPDX-License-Identifier: MIT
// Penumbrae against closed forms and against the truth.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <ombrage/metrics.h>
#include <ombrage/reference.h>

#include "techniques/shadow/planar/wall_fixture.h"

namespace ombrage::test {
namespace {

/// A half plane x > 0.
Scene edgeUnderALamp(float radius_m) {
    Scene scene = wallAndFarLamp();
    scene.lights[0].radius_m = radius_m;
    addFarCaster(scene, 0, 40, -40, 40);
    return scene;
}

/// Share of a disk of radius 1 on the side x < t of a chord.
float diskBefore(float t) {
    t = std::clamp(t, -1.0f, 1.0f);
    return 1 - (std::acos(t) - t * std::sqrt(1 - t * t)) / 3.14159265f;
}

TEST(ShadowPlanar, APointLightRunsNoBlur) {
    const Scene hard = edgeUnderALamp(0), soft = edgeUnderALamp(4);
    for (const char* blur : {"contact", "constant"}) {
        const std::string technique = "shadow/planar:blur=" + std::string(blur);
        EXPECT_FALSE(Wall(hard, technique).ran("planar blur"));
        EXPECT_TRUE(Wall(soft, technique).ran("planar blur"));
    }
    const Wall off(soft, "shadow/planar:blur=off");
    EXPECT_FALSE(off.ran("planar blur"));
    EXPECT_EQ(off.result().visibility, Wall(hard).result().visibility);
}

// Halfway up, the light's image on the wall is as large as the light: the edge covers a disk of radius r about each
// point.
TEST(ShadowPlanar, AnEdgesPenumbraIsTheShareOfTheLight) {
    for (const float radius_m : {4.0f, 8.0f}) {
        const Wall wall(edgeUnderALamp(radius_m), "shadow/planar:samples=128");
        for (float x = -15.5f; x < 16; ++x)
            // 1 / 128 for the sum, a pixel in 2 r for the mask's edge, and the rest because the light's disk faces the
            // point.
            EXPECT_NEAR(wall.at(x, 0.5f), diskBefore(-x / radius_m), 0.03f) << x << " of " << radius_m;
    }
}

TEST(ShadowPlanar, AConstantBlurHasItsWidthWhateverTheLight) {
    for (const float radius_m : {1.0f, 4.0f})
        for (const char* width : {"width=10", "width-px=10"}) {
            const Wall wall(edgeUnderALamp(radius_m), "shadow/planar:blur=constant,samples=128," + std::string(width));
            for (float x = -15.5f; x < 16; ++x) EXPECT_NEAR(wall.at(x, 0.5f), diskBefore(-x / 5), 0.03f) << x;
        }
}

TEST(ShadowPlanar, PenumbraeGrowWithTheHeightOfTheCaster) {
    Scene scene = edgeUnderALamp(6);
    // A blade that leans from the wall's lower border to 20 m over its upper one.
    scene.meshes[1].positions = {{0, -16, 0.1f}, {40, -16, 0.1f}, {40, 16, 20}, {0, 16, 20}};
    // Its lower half is before the camera: the half of the penumbra that it does not hide.
    const auto width = [](const Wall& wall, float y) {
        int partial = 0;
        for (float x = -15.5f; x < 0; ++x) partial += wall.at(x, y) > 0.05f && wall.at(x, y) < 0.95f ? 1 : 0;
        return partial;
    };
    const Wall contact(scene), constant(scene, "shadow/planar:blur=constant,width=8");
    // 6 k(h) with k(h) = h / (40 - h): h is 1.3 m in the row at -14.5, and 13.5 m in that at 8.5.
    EXPECT_LE(width(contact, -14.5f), 1);
    EXPECT_NEAR(width(contact, 8.5f), 3, 1);
    EXPECT_NEAR(width(constant, -14.5f), width(constant, 8.5f), 1);
}

/// The scene of a pole, a thicker one and rungs, whose sun has a size; they receive nothing, so that the floor alone is
/// measured.
Metrics measuredRamp(const std::string& technique, const std::string& camera, float angle_rad = 0.06f) {
    Scene scene = loadScene("penumbra-ramp");
    scene.lights[0].angle_rad = angle_rad;
    for (Model& model : scene.models) model.receives = model.name == "floor";
    RenderSettings settings;
    settings.width = 320;
    settings.height = 180;
    settings.camera = camera;
    settings.shadow = parsePipeline(Family::Shadow, technique);
    const RenderResult result = renderFlat(scene, settings);

    const Reference reference(scene);
    ReferenceOptions options;
    options.width = settings.width;
    options.height = settings.height;
    options.samplesPerPixel = 256;
    const Camera& eye = scene.cameras[std::size_t(scene.cameraIndex(camera))];
    const Receivers receivers = reference.receivers(eye, options);
    ShadowTruth truth = reference.shadow(receivers, eye, 0, options);
    maskDisagreement(truth.mask, truth.maskedShare, receivers, result.instance, result.triangle);
    return measureShadow(result.visibility.at(0).plane(0), truth, receivers, {}).metrics;
}

TEST(ShadowPlanar, BlurComesNearerToTheTruthAndNearestByContact) {
    for (const char* camera : {"main", "left", "top"}) {
        const double off = *measuredRamp("shadow/planar:blur=off", camera).at("hard_ratio");
        const double constant = *measuredRamp("shadow/planar:blur=constant,width=0.04", camera).at("hard_ratio");
        const double contact = *measuredRamp("shadow/planar", camera).at("hard_ratio");
        // Without a blur it is the plain hard shadow but for the rounding at edges.
        EXPECT_NEAR(off, 1, 0.05) << camera;
        EXPECT_LT(constant, 0.85) << camera;
        // Measured 0.11 to 0.17.
        EXPECT_LT(contact, 0.25) << camera;
    }
}

// Directions even in the cone about the sun, those over the wall counted.
TEST(ShadowPlanar, OfASunThatHasPartlySunkTheShareAbovePasses) {
    for (const float elevation_deg : {20.0f, 50.0f})
        for (const float half_deg : {30.0f, 60.0f, 85.0f}) {
            Scene scene = wallAndLamp();
            const float elevation_rad = glm::radians(elevation_deg), half_rad = glm::radians(half_deg);
            scene.lights[0].type = LightType::Sun;
            scene.lights[0].direction = {std::cos(elevation_rad), 0, -std::sin(elevation_rad)};
            scene.lights[0].angle_rad = 2 * half_rad;
            // A caster, for a plane without any has no pass; too small to be seen.
            addQuad(scene, {{14, 14, 1}, {14.001f, 14, 1}, {14.001f, 14.001f, 1}, {14, 14.001f, 1}}, 0.2f);
            int above = 0, all = 0;
            for (int i = 0; i < 400; ++i)
                for (int j = 0; j < 400; ++j, ++all) {
                    const float height = 1 - (float(i) + 0.5f) / 400 * (1 - std::cos(half_rad));
                    const float aside = std::sqrt(1 - height * height);
                    const float turn_rad = (float(j) + 0.5f) / 400 * 6.2831853f;
                    above += height * std::sin(elevation_rad) + aside * std::cos(turn_rad) * std::cos(elevation_rad) > 0
                                 ? 1
                                 : 0;
                }
            // Half floats at 1, and the lattice of 400 squared.
            EXPECT_NEAR(Wall(scene).at(-5.5f, 0.5f), float(above) / float(all), 0.002f)
                << elevation_deg << " " << half_deg;
        }
}

TEST(ShadowPlanar, ASunThatHasPartlySunkHasHalfShadows) {
    // At an elevation of 38 degrees: 46, 103 and 160 degrees wide.
    for (const float angle_rad : {0.8f, 1.8f, 2.8f})
        for (const char* camera : {"main", "left", "top"}) {
            // Measured 0.06 to 0.14; a hard shadow has 1.
            EXPECT_LT(*measuredRamp("shadow/planar", camera, angle_rad).at("hard_ratio"), 0.2)
                << camera << " " << angle_rad;
        }
}

}  // namespace
}  // namespace ombrage::test
