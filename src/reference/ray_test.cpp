// SPDX-License-Identifier: MIT
// What a ray may and may not hit: contacts, the receiver's own triangle, holes, models left out.
#include <algorithm>
#include <array>
#include <limits>

#include "reference/ray_scene.h"
#include "reference/test_scenes.h"

namespace ombrage {
namespace {

std::size_t count(const std::vector<Mask>& mask, Mask value) {
    return std::size_t(std::count(mask.begin(), mask.end(), value));
}

/// A floor of 2 m and a plate 1 mm above its half x > 0.3, all moved by `offset`; seen from below the plate's edge.
Scene gapScene(const glm::dvec3& offset) {
    Scene scene;
    test::add(scene, test::slab(-1, 1, 1, 0), offset);
    test::add(scene, test::slab(0.3f, 1, 1, 0.001f), offset);
    scene.lights.push_back(test::sun({1, 0, -1}));
    return scene;
}

TEST(Contact, OneMillimetreIsSeenFarFromTheOrigin) {
    // Light comes from -x, 45 degrees high: the plate's shadow on the floor begins 1 mm inside its edge.
    for (const glm::dvec3& offset : {glm::dvec3(0), glm::dvec3(100, 0, 0), glm::dvec3(5000, 300, -5000)}) {
        const Scene scene = gapScene(offset);
        const Reference reference(scene);
        const auto at = [&](double x) {
            return reference.shadowAt(offset + glm::dvec3(x, 0.1, 0), {0, 0, 1}, 0, 1, 1).mean;
        };
        EXPECT_EQ(at(0.3009), 1.0);
        EXPECT_EQ(at(0.3011), 0.0);
        EXPECT_EQ(at(0.9), 0.0);
    }
}

TEST(Contact, OneMillimetreIsSeenAtTheEdgeOfALargeScene) {
    // A second floor 200 m away puts the gap 100 m from the space's zero, where a float steps by 8 micrometres.
    Scene scene = gapScene({100, 0, 0});
    test::add(scene, test::slab(-1, 1, 1, 0), {-100, 0, 0});
    const Reference reference(scene);
    const auto at = [&](double x) { return reference.shadowAt({100 + x, 0.1, 0}, {0, 0, 1}, 0, 1, 1).mean; };
    EXPECT_EQ(at(0.3009), 1.0);
    EXPECT_EQ(at(0.3011), 0.0);
}

TEST(Contact, PicturesSeeTheGapToo) {
    for (const glm::dvec3& offset : {glm::dvec3(0), glm::dvec3(100, 0, 0), glm::dvec3(5000, 0, 0)}) {
        // From the side, under the plate: every receiver on the floor within the plate's shadow is dark.
        Scene scene = gapScene(offset);
        scene.lights[0] = test::sun({0, 0, -1});
        // 0.4 degrees high: from half a millimetre above the floor that is 0.14 m to the far end.
        Camera camera = test::camera(offset + glm::dvec3(0, 0, 0.0005), offset + glm::dvec3(1, 0, 0.0005), {0, 0, 1});
        camera.fovY_rad = 0.007f;
        scene.cameras.push_back(camera);
        const Reference reference(scene);
        const auto options = test::picture(32, 32);
        const Receivers receivers = reference.receivers(scene.cameras[0], options);
        const ShadowTruth truth = reference.shadow(receivers, scene.cameras[0], 0, options);
        std::vector<std::uint32_t> inShadow;
        for (std::size_t i = 0; i < truth.mask.size(); ++i) {
            if (truth.mask[i] != Mask::Valid || receivers.instance[i] != 0) continue;
            const double x = double(receivers.distance_m[i]);  // the rays are nearly level
            if (std::abs(x - 0.3) < 1e-4) continue;
            EXPECT_EQ(truth.visibility[i], x > 0.3 ? 0.0f : 1.0f);
            if (x > 0.3) inShadow.push_back(std::uint32_t(i));
        }
        EXPECT_GE(inShadow.size(), 100u);
        for (const Blocker& blocker : reference.shadowFeatures(receivers, 0, options).blockers(inShadow)) {
            EXPECT_NEAR(blocker.distance_m, 0.001, 1e-6);
            EXPECT_EQ(blocker.instance, 1u);
        }
    }
}

TEST(OwnTriangle, ASphereLitFromTheSideHasNoAcne) {
    Scene scene;
    test::add(scene, shapes::sphere({0, 0, 0}, 1, 64, 32), {1000, 0, 0});
    scene.lights.push_back(test::sun({-1, -0.3f, -0.2f}));
    scene.cameras.push_back(test::camera({1001, 1, 4}, {1000, 0, 0}));
    const Reference reference(scene);
    const auto options = test::picture(160, 120);
    const Receivers receivers = reference.receivers(scene.cameras[0], options);
    const ShadowTruth truth = reference.shadow(receivers, scene.cameras[0], 0, options);
    // A convex body never shades a facet that faces the light.
    std::size_t valid = 0;
    for (std::size_t i = 0; i < truth.mask.size(); ++i) {
        if (truth.mask[i] != Mask::Valid) continue;
        ++valid;
        EXPECT_GT(truth.cosine[i], 0.0f);
        EXPECT_EQ(truth.visibility[i], 1.0f) << i << " cosine " << truth.cosine[i];
    }
    EXPECT_GT(valid, 2000u);
    EXPECT_GT(count(truth.mask, Mask::BelowHorizon), 500u);
    EXPECT_EQ(truth.meanStandardError, 0.0);
}

TEST(OwnTriangle, IsLeftOutByItsId) {
    Scene scene;
    test::add(scene, test::slab(-1, 1, 1, 0));
    const FlatScene flat = flatten(scene);
    const RayScene rays(scene, flat);
    // From well below the plane, so that nothing but the id can tell.
    Ray ray;
    ray.origin = {0.3, 0.1, -0.5};
    ray.direction = {0, 0, 1};
    const auto hit = rays.nearest(ray);
    ASSERT_TRUE(hit);
    EXPECT_TRUE(rays.occluded(ray));
    ray.ownTriangle = hit->triangle;
    EXPECT_FALSE(rays.nearest(ray));
    EXPECT_FALSE(rays.occluded(ray));
    ray.ownTriangle = 1 - hit->triangle;
    EXPECT_TRUE(rays.occluded(ray));
}

TEST(OwnTriangle, NeighboursInOnePlaneDoNotBlockGrazingRays) {
    // A tilted floor of many quads: rounding puts some origins behind it by some 1e-8 of a metre.
    Scene scene;
    test::add(scene, shapes::rectangle({-1, -1, 0.3f}, {2, 0, 0.77f}, {0, 2, 0.31f}, 64, 64), {30, 20, 10});
    const glm::dvec3 u = glm::normalize(glm::dvec3(2, 0, 0.77)),
                     normal = glm::normalize(glm::cross(glm::dvec3(2, 0, 0.77), {0, 2, 0.31}));
    scene.lights.push_back(test::sun(-glm::vec3(u + normal * 0.001)));
    scene.aoRadius_m = 1;
    Camera camera = test::camera({30, 20, 15}, {30, 20, 10});
    camera.orthoHeight_m = 1.0f;
    const Reference reference(scene);
    const auto options = test::picture(200, 200);
    const Receivers receivers = reference.receivers(camera, options);
    const ShadowTruth truth = reference.shadow(receivers, camera, 0, options);
    // The quads' corners are floats: the floor is bent by 2^-24 of its coordinates over a quad of 3 cm, up to 4e-5 of a
    // radian and far below the light's height of 1e-3, so nothing shades anything.
    EXPECT_EQ(count(truth.mask, Mask::Valid), truth.mask.size());
    EXPECT_EQ(std::count(truth.visibility.begin(), truth.visibility.end(), 1.0f),
              std::ptrdiff_t(truth.visibility.size()));
}

TEST(Packets, SayWhatEachRayAloneWouldSay) {
    // From all over a body of cavities and creases in all directions, from very near and through its own triangles.
    const Scene scene = loadScene("menger");
    const FlatScene flat = flatten(scene);
    const RayScene rays(scene, flat);
    std::vector<bool> none(flat.instances.size(), false);
    std::uint32_t state = 1;
    const auto random = [&] { return double((state = state * 1664525u + 1013904223u) >> 8) / (1 << 24); };
    int blocked = 0, free = 0;
    for (int packet = 0; packet < 2000; ++packet) {
        std::array<Ray, RayBundle::kSize> bundle;
        const int count = 1 + packet % RayBundle::kSize;
        for (int i = 0; i < count; ++i) {
            Ray& ray = bundle[std::size_t(i)];
            const auto triangle = std::uint32_t(random() * double(flat.triangles.size()));
            const glm::uvec3 t = flat.triangles[triangle];
            const double u = random(), v = random() * (1 - u);
            ray.origin = glm::dvec3(flat.positions[t.x]) * (1 - u - v) + glm::dvec3(flat.positions[t.y]) * u +
                         glm::dvec3(flat.positions[t.z]) * v;
            do ray.direction = glm::dvec3(random(), random(), random()) * 2.0 - 1.0;
            while (glm::length(ray.direction) < 0.1);
            ray.direction = glm::normalize(ray.direction);
            ray.length_m = i % 3 == 0 ? 0.05 : i % 3 == 1 ? 1.0 : std::numeric_limits<double>::infinity();
            if (i % 4 != 0) ray.ownTriangle = triangle;
            if (i % 7 == 0) ray.instances = &none;
        }
        const std::uint32_t found = rays.occluded(bundle.data(), count);
        for (int i = 0; i < count; ++i) {
            const bool alone = rays.occluded(bundle[std::size_t(i)]);
            EXPECT_EQ((found >> i & 1u) != 0, alone) << "packet " << packet << ", ray " << i;
            ++(alone ? blocked : free);
        }
        EXPECT_EQ(found >> count, 0u) << "lanes beyond the last";
    }
    EXPECT_GT(blocked, 1000);
    EXPECT_GT(free, 1000);
}

/// A plate of 1 m above a floor, cut out by a texture of 2x2 texels whose top left and bottom right ones are open.
Scene cutOutScene() {
    Scene scene;
    test::add(scene, test::slab(-2, 2, 2, 0));
    Mesh plate = test::slab(0, 1, 0.5f, 1);
    // Twice the texture in each direction, so that wrapping is used; v = 0 is the top row.
    for (std::size_t i = 0; i < plate.positions.size(); ++i)
        plate.uvs[i] = {2 * plate.positions[i].x, 2 * (0.5f - plate.positions[i].y) - 3};
    test::add(scene, plate);
    Texture texture;
    texture.width = texture.height = 2;
    texture.rgba = {255, 255, 255, 0, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 0};
    scene.textures.push_back(texture);
    Material leaf;
    leaf.alphaMode = AlphaMode::Mask;
    leaf.baseColorTexture = 0;
    scene.materials.push_back(leaf);
    scene.meshes[1].material = 1;
    scene.lights.push_back(test::sun({0, 0, -1}));
    return scene;
}

TEST(Holes, CutOutTexelsLetLightAndSightThrough) {
    const Scene scene = cutOutScene();
    const Reference reference(scene);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x) {
            // Cells of a quarter of a metre; column and row of the 2x2 texture alternate.
            const glm::dvec3 p(0.125 + 0.25 * x, 0.375 - 0.25 * y, 0);
            const bool open = (x + y) % 2 == 0;
            EXPECT_EQ(reference.shadowAt(p, {0, 0, 1}, 0, 1, 1).mean, open ? 1.0 : 0.0) << x << " " << y;
        }
    // From above, half of the plate is seen and through the other half the floor.
    Camera camera = test::camera({0.5, 0, 3}, {0.5, 0, 0});
    camera.orthoHeight_m = 1.0f;
    const Receivers receivers = reference.receivers(camera, test::picture(64, 64));
    EXPECT_EQ(std::count(receivers.instance.begin(), receivers.instance.end(), 1u), 64 * 64 / 2);
    EXPECT_EQ(std::count(receivers.instance.begin(), receivers.instance.end(), 0u), 64 * 64 / 2);
}

TEST(Holes, CutOffIsExclusive) {
    Scene scene;
    Material material;
    material.alphaMode = AlphaMode::Mask;
    material.alpha = 0.5f;
    material.alphaCutoff = 0.5f;
    EXPECT_FALSE(isHole(scene, material, {0, 0}));
    material.alpha = 0.4999f;
    EXPECT_TRUE(isHole(scene, material, {0, 0}));
}

/// A plate (model 1) 1 m above a floor (model 0), over the half x > 0.
Scene plateScene() {
    Scene scene;
    test::add(scene, test::slab(-2, 2, 2, 0));
    test::add(scene, test::slab(0, 2, 2, 1));
    scene.lights.push_back(test::sun({0, 0, -1}));
    scene.aoRadius_m = 5;
    Camera camera = test::camera({0, 0, 5}, {0, 0, 0});
    camera.orthoHeight_m = 2.0f;
    scene.cameras.push_back(camera);
    return scene;
}

double shadowUnderPlate(const Scene& scene) {
    return Reference(scene).shadowAt({1, 0, 0}, {0, 0, 1}, 0, 1, 1).mean;
}

TEST(Models, ThatDoNotCastAreSeenButDoNotShade) {
    Scene scene = plateScene();
    EXPECT_EQ(shadowUnderPlate(scene), 0.0);
    scene.models[1].casts = false;
    EXPECT_EQ(shadowUnderPlate(scene), 1.0);
    const Reference reference(scene);
    const Receivers receivers = reference.receivers(scene.cameras[0], test::picture(32, 32));
    EXPECT_EQ(std::count(receivers.instance.begin(), receivers.instance.end(), 1u), 32 * 32 / 2);
    // Occlusion of the surroundings asks all models.
    EXPECT_LT(reference.aoAt({1, 0, 0}, {0, 0, 1}, 5, 256, 1).mean, 0.5);
}

TEST(Models, ExcludedOnesNeitherShadeNorReceive) {
    Scene scene = plateScene();
    scene.lights[0].excludedModels = {1};
    EXPECT_EQ(shadowUnderPlate(scene), 1.0);
    const Reference reference(scene);
    const auto options = test::picture(32, 32);
    const Receivers receivers = reference.receivers(scene.cameras[0], options);
    const ShadowTruth truth = reference.shadow(receivers, scene.cameras[0], 0, options);
    EXPECT_EQ(count(truth.mask, Mask::NotReceiving), 32u * 32 / 2);
    EXPECT_EQ(truth.maskedShare, 0.5);
    for (std::size_t i = 0; i < truth.mask.size(); ++i)
        EXPECT_EQ(truth.irradiance[i], truth.mask[i] == Mask::NotReceiving ? 0.0f : 1.0f);
}

TEST(Models, ThatDoNotReceiveAreLitAndNotMeasured) {
    Scene scene = plateScene();
    scene.models[0].receives = false;
    const Reference reference(scene);
    const auto options = test::picture(32, 32);
    const Receivers receivers = reference.receivers(scene.cameras[0], options);
    const ShadowTruth truth = reference.shadow(receivers, scene.cameras[0], 0, options);
    for (std::size_t i = 0; i < truth.mask.size(); ++i) {
        EXPECT_EQ(truth.mask[i], receivers.instance[i] == 0 ? Mask::NotReceiving : Mask::Valid);
        EXPECT_EQ(truth.visibility[i], 1.0f);
        EXPECT_EQ(truth.irradiance[i], 1.0f);
    }
}

TEST(Masks, RangeConeHorizonAndSky) {
    Scene scene;
    test::add(scene, test::slab(-2, 2, 2, 0));
    Light spot = test::point({0, 0, 1});
    spot.type = LightType::Spot;
    spot.direction = {0, 0, -1};
    spot.outer_rad = std::atan(0.5f);
    Light below = test::point({0, 0, -1});
    Light lamp = test::point({0, 0, 1});
    lamp.range_m = std::sqrt(2.0f);
    scene.lights = {spot, below, lamp};
    Camera camera = test::camera({0, 0, 5}, {0, 0, 0});
    camera.orthoHeight_m = 8.0f;  // the floor fills the middle quarter
    const Reference reference(scene);
    const auto options = test::picture(64, 64);
    const Receivers receivers = reference.receivers(camera, options);
    const std::vector<Mask> cone = reference.shadow(receivers, camera, 0, options).mask;
    const ShadowTruth horizon = reference.shadow(receivers, camera, 1, options);
    const std::vector<Mask> range = reference.shadow(receivers, camera, 2, options).mask;
    EXPECT_EQ(count(cone, Mask::Sky), 64u * 64 * 3 / 4);
    EXPECT_EQ(count(horizon.mask, Mask::BelowHorizon), 64u * 64 / 4);
    EXPECT_EQ(horizon.maskedShare, 1.0);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const std::size_t i = std::size_t(y * 64 + x);
            if (cone[i] == Mask::Sky) continue;
            const double r = std::hypot((x + 0.5) / 8 - 4, (y + 0.5) / 8 - 4);
            // 1e-4: the position as a float decides on the circle itself.
            if (std::abs(r - 0.5) > 1e-4) {
                EXPECT_EQ(cone[i], r < 0.5 ? Mask::Valid : Mask::OutOfRange) << r;
            }
            if (std::abs(r - 1.0) > 1e-4) {
                EXPECT_EQ(range[i], r < 1.0 ? Mask::Valid : Mask::OutOfRange) << r;
            }
        }
}

TEST(Masks, DisagreementIsMarkedAndCounted) {
    Scene scene = plateScene();
    const Reference reference(scene);
    const auto options = test::picture(32, 32);
    const Receivers receivers = reference.receivers(scene.cameras[0], options);
    ShadowTruth truth = reference.shadow(receivers, scene.cameras[0], 0, options);
    EXPECT_EQ(truth.maskedShare, 0.0);
    auto instance = receivers.instance;
    auto triangle = receivers.triangle;
    triangle[5] += 1;
    instance[7] = kNoHit;
    maskDisagreement(truth.mask, truth.maskedShare, receivers, instance, triangle);
    EXPECT_EQ(count(truth.mask, Mask::Disagree), 2u);
    EXPECT_EQ(truth.mask[5], Mask::Disagree);
    EXPECT_DOUBLE_EQ(truth.maskedShare, 2.0 / 1024);
}

TEST(Receivers, SayWhereAndHowTheSurfaceLies) {
    // A floor whose normals lean, seen from below at 2 m: the normals are turned to the viewer.
    Scene scene;
    Mesh floor = test::slab(-3, 3, 3, 0);
    for (glm::vec3& n : floor.normals) n = glm::normalize(glm::vec3(0.1f, 0, 1));
    test::add(scene, floor, {5000, 0, 0});
    Camera camera = test::camera({5000, 0, -2}, {5000, 0, 0});
    camera.fovY_rad = 2 * std::atan(0.5f);
    const Reference reference(scene);
    const Receivers r = reference.receivers(camera, test::picture(9, 5));
    const std::size_t middle = 2 * 9 + 4;
    EXPECT_EQ(r.instance[middle], 0u);
    EXPECT_NEAR(r.distance_m[middle], 2, 1e-6);
    EXPECT_NEAR(r.pixelSize_m[middle], 2.0 / 5, 1e-6);
    EXPECT_EQ(r.normal[middle], glm::vec3(0, 0, -1));
    EXPECT_NEAR(glm::length(r.shadingNormal[middle] - glm::normalize(glm::vec3(-0.1f, 0, -1))), 0, 1e-6);
}

TEST(Receivers, AnEmptySceneIsAllSky) {
    Scene scene;
    scene.lights.push_back(test::sun({0, 0, -1}));
    scene.aoRadius_m = 1;
    const Camera camera = test::camera({0, 0, 5}, {0, 0, 0});
    const Reference reference(scene);
    const auto options = test::picture(8, 8);
    const Receivers receivers = reference.receivers(camera, options);
    const ShadowTruth truth = reference.shadow(receivers, camera, 0, options);
    EXPECT_EQ(count(truth.mask, Mask::Sky), 64u);
    EXPECT_EQ(truth.maskedShare, 0.0);
}

}  // namespace
}  // namespace ombrage
