// SPDX-License-Identifier: MIT
#include <algorithm>
#include <functional>

#include <ombrage/reference.h>
#include <glm/gtc/matrix_transform.hpp>

#include "render_fixture.h"
#include "scene/camera_view.h"
#include "scene/flat_scene.h"
#include "scene/shapes.h"

namespace ombrage {
namespace {

constexpr int kWidth = 96, kHeight = 54;

RenderSettings show(std::vector<std::string> names, NormalSource normals = NormalSource::Map) {
    RenderSettings settings;
    settings.width = kWidth;
    settings.height = kHeight;
    settings.normals = normals;
    settings.show = std::move(names);
    return settings;
}

glm::vec3 vectorAt(const Image& image, std::size_t i) {
    return {image.plane(0)[i], image.plane(1)[i], image.plane(2)[i]};
}

class GBufferTest : public RenderTest {
protected:
    /// Depth, positions and normals against the rays', wherever both see one triangle.
    static void expectTruth(const Scene& scene, double relative) {
        const RenderResult raster =
            render(scene, show({"depth", "position", "geometric-normal", "normal"}, NormalSource::Geometry));
        const Reference reference(scene);
        ReferenceOptions options;
        options.width = kWidth;
        options.height = kHeight;
        const Receivers truth = reference.receivers(scene.cameras[0], options);
        const glm::dvec3 origin = flatten(scene).origin;
        const CameraView view = makeCameraView(scene.cameras[0], kWidth, kHeight, origin, scene.bounds());
        std::size_t compared = 0, badDepth = 0, badPosition = 0, badGeometric = 0, badShading = 0;
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const std::size_t i = std::size_t(y) * kWidth + std::size_t(x);
                const float depth = raster.shownRaw.at("depth").plane(0)[i];
                EXPECT_EQ(std::isinf(depth), raster.triangle[i] == kNoHit);
                if (raster.triangle[i] != truth.triangle[i] || truth.triangle[i] == kNoHit) continue;
                ++compared;
                glm::dvec3 start, direction;
                view.ray(x + 0.5, y + 0.5, start, direction);
                const glm::dvec3 hit = start + direction * double(truth.distance_m[i]);
                const double along = glm::dot(hit - glm::dvec3(view.eye), glm::dvec3(view.forward));
                // Depth along the axis; a slanted surface turns the rasteriser's 1/256 of a pixel into depth, hence the
                // slope.
                const double cosine = std::abs(glm::dot(glm::dvec3(truth.normal[i]), direction));
                const double allowed = along * relative + double(truth.pixelSize_m[i]) / 256 / std::max(cosine, 1e-3);
                if (std::abs(double(depth) - along) > allowed) ++badDepth;
                const glm::dvec3 position = glm::dvec3(vectorAt(raster.shownRaw.at("position"), i)) - origin;
                // World positions are written as floats: one step at their size more.
                if (glm::length(position - hit) > 2 * allowed + 1.2e-7 * glm::length(hit + origin)) ++badPosition;
                // 16-bit octahedral normals are good to 7e-5 rad; the triangle's own was packed with 16 bits before.
                if (glm::length(vectorAt(raster.shownRaw.at("geometric-normal"), i) - truth.normal[i]) > 2e-4f)
                    ++badGeometric;
                // Interpolated over a triangle: 1/256 of a pixel again moves it by less than that.
                if (glm::length(vectorAt(raster.shownRaw.at("normal"), i) - truth.shadingNormal[i]) > 2e-3f)
                    ++badShading;
            }
        SCOPED_TRACE(scene.name);
        EXPECT_GT(compared, std::size_t(kWidth * kHeight / 20)) << "too little is seen to say anything";
        EXPECT_EQ(badDepth, 0u) << "of " << compared;
        EXPECT_EQ(badPosition, 0u) << "of " << compared;
        EXPECT_EQ(badGeometric, 0u) << "of " << compared;
        // Where n_s is nearly square to n_g, its side is a matter of rounding.
        EXPECT_LE(badShading, compared / 500) << "of " << compared;
    }
};

// 24 bits of depth, one division and a 24-bit product on the way: a few steps of 6e-8.
constexpr double kFloat = 5e-7;

TEST_F(GBufferTest, MeetsTheTruthThroughAPerspectiveCamera) {
    for (const char* name : {"gap", "room", "sphere", "cornell", "open-mesh", "disk"})
        expectTruth(loadScene(name), kFloat);
}

TEST_F(GBufferTest, MeetsTheTruthThroughAnOrthographicCamera) {
    for (const char* name : {"gap", "sphere", "open-mesh"}) {
        Scene scene = loadScene(name);
        scene.cameras[0].orthoHeight_m = 4.0f;
        // Depth is spread evenly over the whole range, so a step is 6e-8 of the far distance, not of the pixel's own.
        expectTruth(scene, 4 * kFloat);
    }
}

TEST_F(GBufferTest, MeetsTheTruthForMirroredAndUnevenInstances) {
    Scene scene = loadScene("sphere");
    const glm::dmat4 first = scene.instances[0].worldFromLocal;
    for (Instance& instance : scene.instances)
        instance.worldFromLocal = glm::scale(glm::dmat4(1), {-1, 1, 1}) * instance.worldFromLocal;
    expectTruth(scene, kFloat);
    scene.instances[0].worldFromLocal = glm::scale(glm::dmat4(1), {0.7, 1.2, -0.8}) * first;
    expectTruth(scene, kFloat);
}

Mesh box() {
    Mesh mesh = shapes::box(glm::vec3(-1), glm::vec3(1));
    mesh.tangents.assign(mesh.positions.size(), glm::vec4(1, 0, 0, 1));
    return mesh;
}

/// Back faces of solids are not drawn, but for an eye inside of one; and mirrored instances, whose fronts are wound the
/// other way, stay whole.
TEST_F(GBufferTest, SolidsAreSeenFromWithinAndMirrored) {
    Scene scene;
    hand::add(scene, box(), hand::matte(glm::vec3(0.5f)));
    scene.lights = {hand::sun({0, -1, -1}, 1)};
    const auto skyPixels = [&](const glm::dvec3& eye, const glm::dvec3& target) {
        scene.cameras = {hand::camera(eye, target)};
        const RenderResult result = render(scene, show({}));
        return std::count(result.triangle.begin(), result.triangle.end(), kNoHit);
    };
    EXPECT_EQ(skyPixels({0, 0, 0}, {1, 0.2, 0.3}), 0) << "from within there are walls all around";
    const auto outside = skyPixels({3, 1, 4}, {0, 0, 0});
    EXPECT_GT(outside, kWidth * kHeight / 4);
    EXPECT_LT(outside, kWidth * kHeight * 9 / 10);
    scene.instances[0].worldFromLocal = glm::scale(glm::dmat4(1), {-1, 1, 1});
    EXPECT_EQ(skyPixels({3, 1, 4}, {0, 0, 0}), outside);
}

/// A light inside of a solid has its back faces for casters.
TEST_F(GBufferTest, ALampInABoxLightsNothingOutside) {
    Scene scene;
    hand::add(scene, box(), hand::matte(glm::vec3(0.5f)));
    Mesh floor = shapes::floor(20, -1.5f);
    floor.tangents.assign(floor.positions.size(), glm::vec4(1, 0, 0, 1));
    hand::add(scene, floor, hand::matte(glm::vec3(0.5f)));
    scene.lights = {hand::at(LightType::Point, {0, 0, 0}, {0, -1, 0}, 10)};
    scene.cameras = {hand::camera({4, 3, 5}, {0, -1, 0})};
    RenderSettings settings = show({});
    settings.shadow = parsePipeline(Family::Shadow, "map");
    const RenderResult result = render(scene, settings);
    std::size_t floorPixels = 0;
    for (std::size_t i = 0; i < result.instance.size(); ++i) {
        if (result.instance[i] != 1) continue;
        ++floorPixels;
        EXPECT_EQ(result.visibility.at(0).plane(0)[i], 0.0f) << "pixel " << i;
    }
    EXPECT_GT(floorPixels, std::size_t(kWidth * kHeight / 10));
}

/// Row 0 is the top row and column 0 the left one: a wall in the upper left quarter of the picture.
TEST_F(GBufferTest, TheTopRowIsTheTop) {
    Scene scene;
    hand::add(scene, hand::wall(), hand::matte(glm::vec3(0.5f)), hand::moved({-1, 1, 0}));
    scene.lights = {hand::sun({0, 0, -1}, 1)};
    scene.cameras = {hand::camera({0, 0, 2}, {0, 0, 0})};
    scene.cameras[0].orthoHeight_m = 4;
    const RenderResult result = render(scene, show({"position"}));
    const auto triangleAt = [&](int x, int y) { return result.triangle[std::size_t(y) * kWidth + std::size_t(x)]; };
    EXPECT_NE(triangleAt(kWidth / 2 - 5, 5), kNoHit);
    EXPECT_EQ(triangleAt(kWidth / 2 + 5, 5), kNoHit);
    EXPECT_EQ(triangleAt(kWidth / 2 - 5, kHeight - 5), kNoHit);
    const Image& position = result.shownRaw.at("position");
    // Pixel (0.5, 0.5) of an orthographic picture 4 m high: y = 2 - 4 * 5.5/54.
    EXPECT_NEAR(position.at(1, kWidth / 2 - 5, 5), 2 - 4 * 5.5 / 54, 1e-5);
}

/// The mean shading normal over the picture.
glm::vec3 meanNormal(const RenderResult& result) {
    const Image& normals = result.shownRaw.at("normal");
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < normals.pixelCount(); ++i)
        if (result.triangle[i] != kNoHit) sum += glm::dvec3(vectorAt(normals, i));
    return glm::normalize(sum);
}

/// A wall with a texture made by a function of the texel.
Scene texturedWall(int Material::*slot, const std::function<glm::u8vec3(int x, int y)>& texel) {
    Scene scene = hand::wallScene();
    Texture texture;
    texture.width = texture.height = 64;
    texture.srgb = false;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const glm::u8vec3 value = texel(x, y);
            texture.rgba.insert(texture.rgba.end(), {value.x, value.y, value.z, 255});
        }
    scene.textures.push_back(texture);
    scene.materials[0].*slot = 0;
    scene.materials[0].heightScale_uv = 0.5f;
    // The middle of the wall alone, clear of the ramp's jump where it repeats.
    scene.cameras[0].orthoHeight_m = 0.9f;
    return scene;
}

// The ramp rises by 0.5 (height scale) over one unit of uv, so its slope is 0.5 and the normal leans by atan 0.5. 8-bit
// heights give steps of 4 of 255 per texel: exact on the mean to 64 * 4 / 255 = 1.004.
const float kLean = 0.5f * 64 * 4 / 255, kAcross = kLean / std::sqrt(1 + kLean * kLean);
constexpr float kMapTolerance = 0.01f;  ///< forward differences over one texel, filtered

TEST_F(GBufferTest, AHeightThatRisesTowardsUTiltsTheNormalAgainstU) {
    const Scene scene = texturedWall(&Material::heightTexture, [](int x, int) { return glm::u8vec3(x * 4); });
    for (NormalSource source : {NormalSource::Bump, NormalSource::Map}) {
        const glm::vec3 n = meanNormal(render(scene, show({"normal"}, source)));
        EXPECT_NEAR(n.x, -kAcross, kMapTolerance);
        EXPECT_NEAR(n.y, 0, kMapTolerance);
        EXPECT_GT(n.z, 0);
    }
}

TEST_F(GBufferTest, AHeightThatRisesUpTheTextureTiltsTheNormalDown) {
    // v = 0 is the top row: heights grow towards smaller v, which is +y on the wall.
    const Scene scene = texturedWall(&Material::heightTexture, [](int, int y) { return glm::u8vec3((63 - y) * 4); });
    const glm::vec3 n = meanNormal(render(scene, show({"normal"}, NormalSource::Bump)));
    EXPECT_NEAR(n.x, 0, kMapTolerance);
    EXPECT_NEAR(n.y, -kAcross, kMapTolerance);
}

TEST_F(GBufferTest, GeometryNormalsIgnoreMaps) {
    const Scene scene = texturedWall(&Material::heightTexture, [](int x, int) { return glm::u8vec3(x * 4); });
    EXPECT_NEAR(meanNormal(render(scene, show({"normal"}, NormalSource::Geometry))).z, 1, 1e-4);
}

// (0.6, 0, 0.8) in 8 bits.
Scene normalMapped(const glm::vec3& n) {
    return texturedWall(&Material::normalTexture,
                        [n](int, int) { return glm::u8vec3(glm::round((n * 0.5f + 0.5f) * 255.0f)); });
}

void expectNear(const glm::vec3& got, const glm::vec3& expected) {
    // 8 bits of a normal map are 1/255 per axis.
    EXPECT_LT(glm::length(got - expected), 0.008f) << got.x << " " << got.y << " " << got.z;
}

TEST_F(GBufferTest, ANormalMapTiltsAlongTheTangentAndUpTheTexture) {
    expectNear(meanNormal(render(normalMapped({0.6f, 0, 0.8f}), show({"normal"}))), {0.6f, 0, 0.8f});
    expectNear(meanNormal(render(normalMapped({0, 0.6f, 0.8f}), show({"normal"}))), {0, 0.6f, 0.8f});
    Scene half = normalMapped({0.6f, 0, 0.8f});
    half.materials[0].normalScale = 0.5f;
    expectNear(meanNormal(render(half, show({"normal"}))), glm::normalize(glm::vec3(0.3f, 0, 0.8f)));
}

TEST_F(GBufferTest, AMirroredWallMirrorsItsNormalMap) {
    for (const glm::vec3& mapped : {glm::vec3(0.6f, 0, 0.8f), glm::vec3(0, 0.6f, 0.8f)}) {
        Scene scene = normalMapped(mapped);
        scene.instances[0].worldFromLocal = glm::scale(glm::dmat4(1), {-1, 1, 1});
        expectNear(meanNormal(render(scene, show({"normal"}))), {-mapped.x, mapped.y, mapped.z});
        scene.instances[0].worldFromLocal = glm::scale(glm::dmat4(1), {1, -1, 1});
        expectNear(meanNormal(render(scene, show({"normal"}))), {mapped.x, -mapped.y, mapped.z});
    }
}

TEST_F(GBufferTest, ATurnedWallTurnsItsNormalMap) {
    Scene scene = normalMapped({0.6f, 0, 0.8f});
    scene.instances[0].worldFromLocal = glm::rotate(glm::dmat4(1), 1.5707963267948966, glm::dvec3(0, 0, 1));
    expectNear(meanNormal(render(scene, show({"normal"}))), {0, 0.6f, 0.8f});
}

TEST_F(GBufferTest, TheBackOfAMappedWallHasTheReversedNormal) {
    // As glTF asks of double-sided surfaces: a bump seen from the front is a dent seen from the back.
    Scene scene = normalMapped({0.6f, 0, 0.8f});
    scene.cameras[0].position.z = -2;
    expectNear(meanNormal(render(scene, show({"normal"}))), {-0.6f, 0, -0.8f});
    Scene ramp = texturedWall(&Material::heightTexture, [](int x, int) { return glm::u8vec3(x * 4); });
    ramp.cameras[0].position.z = -2;
    EXPECT_NEAR(meanNormal(render(ramp, show({"normal"}, NormalSource::Bump))).x, kAcross, kMapTolerance);
}

TEST_F(GBufferTest, AlbedoAndMaterialAreTheSurfaces) {
    Material material = hand::matte({0.5f, 0.25f, 0.03f});
    material.metallic = 0.4f;
    material.roughness = 0.6f;
    material.specular = glm::vec3(0.2f);
    const RenderResult result = render(hand::wallScene(material), show({"albedo", "material"}));
    const std::size_t centre = std::size_t(kHeight / 2) * kWidth + kWidth / 2;
    const Image& albedo = result.shownRaw.at("albedo");
    EXPECT_EQ(albedo.colorSpace(), ColorSpace::Linear);
    // Half a step of 8-bit sRGB: 1/510 encoded, times the transfer function's slope of at most 2.3, is 0.005 at 1.
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(albedo.plane(c)[centre], material.baseColor[c], 0.004f) << c;
    const glm::vec3 surface = vectorAt(result.shownRaw.at("material"), centre);
    EXPECT_LT(glm::length(surface - glm::vec3(0.4f, 0.6f, 0.2f)), 0.004f) << "half a step of 8 bits on each";
}

TEST_F(GBufferTest, TextureRowsAreTopDown) {
    Scene scene = hand::wallScene();
    Texture texture;
    texture.width = texture.height = 2;
    texture.rgba = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255};
    scene.textures.push_back(texture);
    scene.materials[0] = hand::matte(glm::vec3(1));
    scene.materials[0].baseColorTexture = 0;
    scene.cameras[0].orthoHeight_m = 2;
    const RenderResult result = render(scene, show({"albedo"}));
    const Image& albedo = result.shownRaw.at("albedo");
    // Middle of each quarter of the wall: 27 pixels wide and high, about the picture's centre.
    const auto at = [&](int dx, int dy) {
        const std::size_t i = std::size_t(kHeight / 2 + dy * 13) * kWidth + std::size_t(kWidth / 2 + dx * 13);
        return glm::round(vectorAt(albedo, i));
    };
    EXPECT_EQ(at(-1, -1), glm::vec3(1, 0, 0));
    EXPECT_EQ(at(1, -1), glm::vec3(0, 1, 0));
    EXPECT_EQ(at(-1, 1), glm::vec3(0, 0, 1));
    EXPECT_EQ(at(1, 1), glm::vec3(1, 1, 1));
}

}  // namespace
}  // namespace ombrage
