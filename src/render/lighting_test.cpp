// SPDX-License-Identifier: MIT
// Known answers of composing: Lambert surfaces (no highlight), where radiance is albedo / pi times irradiance.
#include <algorithm>

#include <ombrage/reference.h>

#include "render_fixture.h"

namespace ombrage {
namespace {

constexpr double kPi = 3.14159265358979;
const glm::vec3 kAlbedo{0.5f, 0.25f, 0.125f};

RenderSettings small() {
    RenderSettings settings;
    settings.width = 33;
    settings.height = 33;
    return settings;
}

/// The pixel in the middle: the point (0, 0, 0) of the wall, exactly.
glm::vec3 middle(const Image& picture) {
    const int x = picture.width() / 2, y = picture.height() / 2;
    return {picture.at(0, x, y), picture.at(1, x, y), picture.at(2, x, y)};
}

/// Albedo is stored in 8 bits of sRGB (up to 1.5 % at 0.125), the picture in half floats (0.05 %).
void expectRadiance(const glm::vec3& got, const glm::dvec3& expected, const std::string& what = {}) {
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(got[c], expected[c], 0.017 * std::abs(expected[c]) + 1e-5) << what << " channel " << c;
}

class LightingTest : public RenderTest {
protected:
    /// Radiance of the wall's middle over albedo / pi: the irradiance as composed, from the red channel of a white
    /// wall, whose albedo 8 bits hold exactly.
    static double irradiance(const Light& light, const RenderSettings& settings = small()) {
        Scene scene = hand::wallScene(hand::matte(glm::vec3(1)));
        scene.lights = {light};
        return double(middle(render(scene, settings).picture).x) * kPi;
    }
};

// Half floats have 11 bits: 0.05 %; 16-bit normals cost under 0.01 %.
constexpr double kHalf = 1e-3;

TEST_F(LightingTest, ASunGivesItsIlluminanceTimesTheCosine) {
    for (double angle : {0.0, 0.5, 1.2}) {
        Scene scene = hand::wallScene(hand::matte(kAlbedo));
        scene.lights[0] = hand::sun({std::sin(angle), 0, -std::cos(angle)}, 3);
        scene.lights[0].color = {1, 0.5f, 0.25f};
        scene.ambient = 0.2f;
        RenderSettings settings = small();
        const glm::dvec3 direct = glm::dvec3(kAlbedo) / kPi * 3.0 * std::cos(angle) * glm::dvec3(1, 0.5, 0.25);
        for (Shading shading : {Shading::Phong, Shading::Blinn}) {
            settings.shading = shading;
            expectRadiance(middle(render(scene, settings).picture), direct + 0.2 * glm::dvec3(kAlbedo));
        }
    }
}

TEST_F(LightingTest, ASunFromBehindGivesNothing) {
    EXPECT_EQ(irradiance(hand::sun({0, 0, 1}, 3)), 0);
}

TEST_F(LightingTest, MetallicRoughnessKeepsALambertsPartBelowTheHighlight) {
    // Rough dielectric under a sun square to it, seen square: diffuse (1 - 0.04) albedo/pi, and the GGX lobe at its
    // peak: D = 1/pi at alpha 1, visibility 1/4, F = 0.04.
    Material material = hand::matte(kAlbedo);
    material.roughness = 1;
    RenderSettings settings = small();
    settings.shading = Shading::Pbr;
    const glm::dvec3 expected = 3.0 * (0.96 * glm::dvec3(kAlbedo) / kPi + 0.04 / (4 * kPi));
    expectRadiance(middle(render(hand::wallScene(material), settings).picture), expected);
}

TEST_F(LightingTest, PhongAndBlinnHighlightsAreNormalised) {
    // Mirror direction: the lobe is 1 times its normalisation, (n + 2) / 2 pi and (4n + 8) / 8 pi.
    Material material = hand::matte(glm::vec3(0));
    material.specular = glm::vec3(0.2f);
    material.shininess = 10;
    RenderSettings settings = small();
    settings.shading = Shading::Phong;
    expectRadiance(middle(render(hand::wallScene(material), settings).picture), glm::dvec3(3 * 0.2 * 12 / (2 * kPi)));
    settings.shading = Shading::Blinn;
    expectRadiance(middle(render(hand::wallScene(material), settings).picture), glm::dvec3(3 * 0.2 * 48 / (8 * kPi)));
}

TEST_F(LightingTest, APointLightFallsWithTheSquareOfTheDistance) {
    for (double distance : {0.5, 1.0, 3.0})
        EXPECT_NEAR(irradiance(hand::at(LightType::Point, {0, 0, distance}, {0, -1, 0}, 2)), 2 / (distance * distance),
                    kHalf * 8);
    // 60 degrees off the normal: half.
    EXPECT_NEAR(irradiance(hand::at(LightType::Point, {std::sqrt(3), 0, 1}, {0, -1, 0}, 2)), 2.0 / 4 * 0.5, kHalf);
}

TEST_F(LightingTest, NothingReachesBeyondTheRange) {
    Light light = hand::at(LightType::Point, {0, 0, 2}, {0, -1, 0}, 2);
    light.range_m = 2.001f;
    EXPECT_NEAR(irradiance(light), 0.5, kHalf);
    light.range_m = 1.999f;
    EXPECT_EQ(irradiance(light), 0);
}

TEST_F(LightingTest, ARectShinesOnOneSideWithItsAreaAndCosine) {
    Light light = hand::at(LightType::Rect, {0, 0, 2}, {0, 0, -1}, 5);
    light.size_m = {0.3f, 0.2f};
    EXPECT_NEAR(irradiance(light), 5 * 0.06 / 4, kHalf);
    light.direction = {0, 0, 1};
    EXPECT_EQ(irradiance(light), 0);
    // The light's own cosine: turned by 60 degrees it gives half.
    light.direction = glm::normalize(glm::vec3(std::sqrt(3.0f), 0, -1));
    EXPECT_NEAR(irradiance(light), 5 * 0.06 / 4 * 0.5, kHalf);
}

TEST_F(LightingTest, ASpotFadesWithTheSquaredRampBetweenItsCosines) {
    Light light = hand::at(LightType::Spot, {0, 0, 2}, {0, 0, -1}, 4);
    light.inner_rad = 0.2f;
    light.outer_rad = 0.4f;
    for (double angle : {0.0, 0.19, 0.22, 0.26, 0.3, 0.34, 0.38, 0.41}) {
        light.direction = glm::vec3(std::sin(angle), 0, -std::cos(angle));
        // KHR_lights_punctual: t = (cos a - cos outer) / (cos inner - cos outer), kept within 0 and 1, squared.
        const double ramp = (std::cos(angle) - std::cos(0.4)) / (std::cos(0.2) - std::cos(0.4));
        const double share = std::pow(std::min(std::max(ramp, 0.0), 1.0), 2);
        EXPECT_NEAR(irradiance(light), share, kHalf) << angle;
    }
}

TEST_F(LightingTest, EveryLightGivesTheTruthsIrradianceEverywhere) {
    Light rect = hand::at(LightType::Rect, {0.3, 0.2, 1.5}, {-0.2f, 0.1f, -1}, 5000);
    rect.size_m = {0.02f, 0.03f};
    Light spot = hand::at(LightType::Spot, {-0.2, 0.3, 1.5}, {0.2f, -0.1f, -1}, 3);
    for (const Light& light :
         {hand::sun({0.3f, -0.2f, -1}, 3), hand::at(LightType::Point, {0.4, -0.3, 0.8}, {0, -1, 0}, 2), spot, rect}) {
        Scene scene = hand::wallScene(hand::matte(glm::vec3(1)));
        scene.lights = {light};
        scene.cameras = {hand::camera({0.5, 0.4, 2}, {0, 0, 0})};
        const Image picture = render(scene, small()).picture;
        const Reference reference(scene);
        ReferenceOptions options;
        options.width = options.height = 33;
        options.samplesPerPixel = 64;
        const Receivers receivers = reference.receivers(scene.cameras[0], options);
        const ShadowTruth truth = reference.shadow(receivers, scene.cameras[0], 0, options);
        std::size_t lit = 0;
        for (std::size_t i = 0; i < picture.pixelCount(); ++i) {
            if (truth.mask[i] != Mask::Valid) continue;
            ++lit;
            // A rect counts as its centre here: with 3 cm at 0.8 m or more, (0.015 / 0.8)^2 is 0.04 %. The steep edge
            // of the spot's cone multiplies the position's rounding, hence the absolute part.
            EXPECT_NEAR(double(picture.plane(0)[i]) * kPi, truth.irradiance[i], kHalf * truth.irradiance[i] + 1e-3)
                << lightTypeName(light.type) << " at " << i;
        }
        EXPECT_GT(lit, picture.pixelCount() / 20) << lightTypeName(light.type);
    }
}

TEST_F(LightingTest, LightsAddUp) {
    Scene scene = hand::wallScene(hand::matte(glm::vec3(1)));
    scene.lights = {hand::sun({0, 0, -1}, 1), hand::at(LightType::Point, {0, 0, 2}, {0, -1, 0}, 8),
                    hand::at(LightType::Spot, {0, 0, 1}, {0, 0, -1}, 0.5f)};
    RenderSettings settings = small();
    EXPECT_NEAR(double(middle(render(scene, settings).picture).x) * kPi, 1 + 2 + 0.5, 3.5 * kHalf);
    settings.light = "point";
    EXPECT_NEAR(double(middle(again(settings).picture).x) * kPi, 2, 2 * kHalf) << "one light alone";
}

TEST_F(LightingTest, EmittedLightAndTheSkyNeedNoLight) {
    Material material = hand::matte(glm::vec3(0));
    material.emissive = {1.5f, 0.5f, 0.25f};
    Scene scene = hand::wallScene(material);
    scene.lights[0].direction = {0, 0, 1};
    scene.ambient = 0.5f;
    scene.cameras[0].orthoHeight_m = 4;
    const Image picture = render(scene, small()).picture;
    expectRadiance(middle(picture), {1.5, 0.5, 0.25});
    expectRadiance({picture.at(0, 0, 0), picture.at(1, 0, 0), picture.at(2, 0, 0)}, glm::dvec3(0.5));
}

TEST_F(LightingTest, TheGeometricHorizonShadowsWhateverTheShadingNormalSays) {
    // Normals that lean to the light, on a wall that faces away from it.
    Scene scene = hand::wallScene(hand::matte(glm::vec3(1)));
    const glm::vec3 leaning = glm::normalize(glm::vec3(0.8f, 0, 0.6f));
    scene.meshes[0].normals.assign(4, leaning);
    scene.lights[0] = hand::sun({-1, 0, 0.1f}, 3);
    EXPECT_GT(glm::dot(leaning, -scene.lights[0].direction), 0.5f);
    EXPECT_EQ(middle(render(scene, small()).picture).x, 0);
}

Image flat(float value) {
    Image image = Image::grey(33, 33, "visibility");
    std::fill(image.plane(0).begin(), image.plane(0).end(), value);
    return image;
}

TEST_F(LightingTest, ModulateDarkensTheWholeColourByEveryLight) {
    Scene scene = hand::wallScene(hand::matte(glm::vec3(1)));
    scene.ambient = 0.2f;
    scene.lights = {hand::sun({0, 0, -1}, 1), hand::sun({0, 0, -1}, 2)};
    RenderSettings settings = small();
    settings.composite = Composite::Modulate;
    settings.givenVisibility = {{0, flat(0.5f)}, {1, flat(0.25f)}};
    const double unshadowed = 0.2 + 3 / kPi;
    EXPECT_NEAR(middle(render(scene, settings).picture).x, unshadowed * 0.125, kHalf);
    settings.composite = Composite::Lighting;
    EXPECT_NEAR(middle(again(settings).picture).x, 0.2 + (1 * 0.5 + 2 * 0.25) / kPi, kHalf);
}

TEST_F(LightingTest, OverlayGivesEveryLightItsPartOfTheOpacity) {
    Scene scene = hand::wallScene(hand::matte(glm::vec3(1)));
    scene.ambient = 0.2f;
    scene.lights = {hand::sun({0, 0, -1}, 1), hand::sun({0, 0, -1}, 2)};
    RenderSettings settings = small();
    settings.composite = Composite::Overlay;
    settings.overlayOpacity = 0.6;
    const double unshadowed = 0.2 + 3 / kPi;
    // One of two lights wholly blocked takes half of the opacity away, both take all of it.
    settings.givenVisibility = {{0, flat(0)}, {1, flat(1)}};
    EXPECT_NEAR(middle(render(scene, settings).picture).x, unshadowed * (1 - 0.3), 2 * kHalf);
    settings.givenVisibility = {{0, flat(0)}, {1, flat(0)}};
    EXPECT_NEAR(middle(again(settings).picture).x, unshadowed * (1 - 0.6), 2 * kHalf);
    settings.givenVisibility = {{0, flat(0.5f)}, {1, flat(1)}};
    EXPECT_NEAR(middle(again(settings).picture).x, unshadowed * (1 - 0.15), 2 * kHalf);
}

TEST_F(LightingTest, AmbientModesChangeTheAmbientTermAlone) {
    Scene scene = hand::wallScene(hand::matte(glm::vec3(1)));
    scene.ambient = 0.2f;
    RenderSettings settings = small();
    settings.ambient = AmbientTerm::Constant;
    EXPECT_NEAR(middle(render(scene, settings).picture).x, 0.2 + 3 / kPi, 1.2 * kHalf);
    settings.ambient = AmbientTerm::Ao;
    EXPECT_NEAR(middle(again(settings).picture).x, 0.2 + 3 / kPi, 1.2 * kHalf) << "ao/none is 1";
    settings.ambient = AmbientTerm::Off;
    EXPECT_NEAR(middle(again(settings).picture).x, 3 / kPi, kHalf);
}

TEST_F(LightingTest, ALightLeavesOutWhatItExcludes) {
    Scene scene = hand::wallScene(hand::matte(glm::vec3(1)));
    scene.lights.push_back(hand::sun({0, 0, -1}, 6));
    scene.lights[0].excludedModels = {0};
    EXPECT_NEAR(middle(render(scene, small()).picture).x, 6 / kPi, 6 * kHalf) << "the second light alone";
}

// A given visibility of 0 stands for any technique's shadow.
TEST_F(LightingTest, AModelThatReceivesNothingStaysLit) {
    Scene scene = hand::wallScene(hand::matte(glm::vec3(1)));
    RenderSettings settings = small();
    settings.givenVisibility[0] = Image::grey(settings.width, settings.height, "visibility");
    EXPECT_NEAR(middle(render(scene, settings).picture).x, 0.0, 1e-5);
    scene.models[0].receives = false;
    EXPECT_NEAR(middle(render(scene, settings).picture).x, 3 / kPi, 3 * kHalf);
}

TEST_F(LightingTest, AGivenVisibilityReplacesTheTechniques) {
    const Scene scene = loadScene("gap");
    RenderSettings settings;
    settings.width = 64;
    settings.height = 36;
    settings.shadow = parsePipeline(Family::Shadow, "map:resolution=256");
    const RenderResult own = render(scene, settings);
    const auto visibility = own.visibility.at(0).plane(0);
    EXPECT_NE(std::count(visibility.begin(), visibility.end(), 0.0f), 0) << "there is a shadow";
    settings.shadow = parsePipeline(Family::Shadow, "none");
    settings.givenVisibility = own.visibility;
    const RenderResult given = again(settings);
    EXPECT_EQ(given.picture, own.picture);
    EXPECT_EQ(given.visibility.at(0), own.visibility.at(0));
    settings.givenVisibility.clear();
    EXPECT_NE(again(settings).picture, own.picture);
}

}  // namespace
}  // namespace ombrage
