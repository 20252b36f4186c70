// SPDX-License-Identifier: MIT
#include <cmath>
#include <functional>
#include <set>

#include <gtest/gtest.h>
#include <ombrage/error.h>
#include <ombrage/scene.h>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/camera_view.h"
#include "scene/flat_scene.h"

namespace ombrage {
namespace {

TEST(Scene, NamesFindTheirIndex) {
    const Scene scene = loadScene("gap");
    EXPECT_EQ(scene.cameraIndex(""), 0);
    EXPECT_EQ(scene.cameraIndex("top"), 2);
    EXPECT_EQ(scene.lightIndex("sun"), 0);
    try {
        scene.cameraIndex("lft");
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Usage);
        EXPECT_NE(error.hint().find("left"), std::string::npos);
    }
}

TEST(Scene, BoundsCoverEveryInstance) {
    Scene scene = loadScene("gap");
    const Bounds bounds = scene.bounds();
    EXPECT_EQ(bounds.lower, glm::dvec3(-3, 0, -3));
    EXPECT_EQ(bounds.upper.y, double(1.001f));
    EXPECT_TRUE(Scene{}.bounds().empty());
    EXPECT_EQ(scene.triangleCount(), 2u * 64u + 12u);
}

TEST(Scene, ContentHashFollowsWhatChangesAPicture) {
    Scene scene = loadScene("gap");
    scene.textures.push_back({"t", 1, 1, true, {1, 2, 3, 4}});
    scene.animations.push_back({"orbit-light", "sun", 4.0});
    const std::vector<std::function<void(Scene&)>> changes = {
        [](Scene& s) { s.textures[0].rgba[1] = 9; },
        [](Scene& s) { s.textures[0].srgb = false; },
        [](Scene& s) { s.materials[0].baseColor.y += 0.1f; },
        [](Scene& s) { s.materials[0].alpha = 0.5f; },
        [](Scene& s) { s.materials[0].specular.x = 0.5f; },
        [](Scene& s) { s.materials[0].shininess = 5; },
        [](Scene& s) { s.materials[0].metallic = 1; },
        [](Scene& s) { s.materials[0].roughness = 0.1f; },
        [](Scene& s) { s.materials[0].emissive.z = 1; },
        [](Scene& s) { s.materials[0].alphaMode = AlphaMode::Mask; },
        [](Scene& s) { s.materials[0].alphaCutoff = 0.4f; },
        [](Scene& s) { s.materials[0].doubleSided = false; },
        [](Scene& s) { s.materials[0].baseColorTexture = 0; },
        [](Scene& s) { s.materials[0].normalTexture = 0; },
        [](Scene& s) { s.materials[0].heightTexture = 0; },
        [](Scene& s) { s.materials[0].metallicRoughnessTexture = 0; },
        [](Scene& s) { s.materials[0].emissiveTexture = 0; },
        [](Scene& s) { s.materials[0].normalScale = 2; },
        [](Scene& s) { s.materials[0].heightScale_uv = 2; },
        [](Scene& s) { s.meshes[0].positions[0].x += 1e-6f; },
        [](Scene& s) { s.meshes[0].normals[0].x += 1e-6f; },
        [](Scene& s) { s.meshes[0].tangents[0].w = -s.meshes[0].tangents[0].w; },
        [](Scene& s) { s.meshes[0].uvs[0].x += 1; },
        [](Scene& s) { std::swap(s.meshes[0].indices[0], s.meshes[0].indices[1]); },
        [](Scene& s) { s.meshes[0].material = 1; },
        [](Scene& s) { s.models[0].casts = false; },
        [](Scene& s) { s.models[0].receives = false; },
        [](Scene& s) { s.instances[0].worldFromLocal[3][1] += 1e-9; },
        [](Scene& s) { s.instances[0].model = 1; },
        [](Scene& s) { s.lights[0].type = LightType::Point; },
        [](Scene& s) { s.lights[0].position.x += 1; },
        [](Scene& s) { s.lights[0].direction.x += 0.1f; },
        [](Scene& s) { s.lights[0].color.x = 0.5f; },
        [](Scene& s) { s.lights[0].intensity = 5; },
        [](Scene& s) { s.lights[0].radius_m = 5; },
        [](Scene& s) { s.lights[0].angle_rad = 0.1f; },
        [](Scene& s) { s.lights[0].size_m.y = 1; },
        [](Scene& s) { s.lights[0].range_m = 1; },
        [](Scene& s) { s.lights[0].inner_rad = 0.1f; },
        [](Scene& s) { s.lights[0].outer_rad = 0.1f; },
        [](Scene& s) { s.lights[0].excludedModels = {1}; },
        [](Scene& s) { s.cameras[0].position.x += 1; },
        [](Scene& s) { s.cameras[0].target.x += 1; },
        [](Scene& s) { s.cameras[0].up.x += 1; },
        [](Scene& s) { s.cameras[0].fovY_rad = 1; },
        [](Scene& s) { s.cameras[0].orthoHeight_m = 1.0f; },
        [](Scene& s) { s.animations[0].period_s = 5; },
        [](Scene& s) {
            s.animations[0] = {"orbit-camera", "", 4.0};
        },
        [](Scene& s) { s.animations[0].instances = {1}; },
        [](Scene& s) { s.animations[0].pivot.y = 1; },
        [](Scene& s) {
            s.animations[0].axis = {0, 1, 0};
        },
        [](Scene& s) { s.animations[0].amplitude_rad = 1; },
        [](Scene& s) { s.animations[0].phase = 0.5; },
        [](Scene& s) { s.ambient = 0.3f; },
        [](Scene& s) { s.aoRadius_m = 0.3f; },
        [](Scene& s) { s.lights.push_back(s.lights[0]); },
    };
    std::set<std::string> hashes = {contentHash(scene)};
    for (const auto& change : changes) {
        Scene changed = scene;
        change(changed);
        hashes.insert(contentHash(changed));
    }
    EXPECT_EQ(hashes.size(), changes.size() + 1) << "every change gives a hash of its own";

    Scene renamed = scene;
    renamed.name = renamed.description = renamed.materials[0].name = renamed.meshes[0].name = "other";
    renamed.models[0].name = renamed.cameras[0].name = renamed.textures[0].name = "other";
    renamed.lights[0].name = renamed.animations[0].light = "other";
    renamed.warnings.push_back("other");
    EXPECT_EQ(contentHash(renamed), contentHash(scene));
}

TEST(Scene, OrbitsTurnAboutTheVerticalAxis) {
    Scene scene = loadScene("gap");
    scene.animations = {{"orbit-camera", "", 4.0}, {"orbit-light", "sun", 2.0}};
    const Scene before = scene;
    animate(scene, 1.0);
    const glm::dvec3 center = before.bounds().center();
    // A quarter turn: x goes to -z. Sines of right angles are good to 1e-15, positions to a few of it.
    const glm::dvec3 arm = before.cameras[0].position - center, turned = scene.cameras[0].position - center;
    EXPECT_NEAR(turned.x, arm.z, 1e-12);
    EXPECT_NEAR(turned.y, arm.y, 1e-12);
    EXPECT_NEAR(turned.z, -arm.x, 1e-12);
    // Half a turn of the light; a float direction.
    EXPECT_NEAR(scene.lights[0].direction.x, -before.lights[0].direction.x, 1e-6);
    EXPECT_NEAR(scene.lights[0].direction.y, before.lights[0].direction.y, 1e-6);
}

TEST(Scene, SwingsStartFromTheLoadedPoseAndCarryWhatComesFirst) {
    // A forearm of 1 m from (1, 0, 0) outwards on an upper arm of 1 m from the origin; both swing about z.
    Scene scene = loadScene("gap");
    scene.instances[0].worldFromLocal[3] = {1, 0, 0, 1};
    scene.instances[1].worldFromLocal[3] = {0, 0, 0, 1};
    Animation elbow{"swing", "", 4.0, {0}, {1, 0, 0}, {0, 0, 1}, glm::radians(90.0), 0.0};
    Animation shoulder{"swing", "", 4.0, {0, 1}, {0, 0, 0}, {0, 0, 1}, glm::radians(90.0), 0.0};
    scene.animations = {elbow, shoulder};
    const auto handAt = [&](double time_s) {
        Scene moved = scene;
        animate(moved, time_s);
        return glm::dvec3(moved.instances[0].worldFromLocal * glm::dvec4(1, 0, 0, 1));
    };
    // Rounding of sines: 1e-15 times lengths of 2. After a quarter period both joints are at 90 degrees.
    EXPECT_NEAR(glm::length(handAt(0.0) - glm::dvec3(2, 0, 0)), 0.0, 1e-12);
    EXPECT_NEAR(glm::length(handAt(1.0) - glm::dvec3(-1, 1, 0)), 0.0, 1e-12);
    EXPECT_NEAR(glm::length(handAt(3.0) - glm::dvec3(-1, -1, 0)), 0.0, 1e-12);
    // The loaded pose is the one at time 0 whatever the phase: from the end of the swing it goes back by its whole.
    scene.animations = {shoulder};
    scene.animations[0].phase = 0.25;
    EXPECT_NEAR(glm::length(handAt(0.0) - glm::dvec3(2, 0, 0)), 0.0, 1e-12);
    EXPECT_NEAR(glm::length(handAt(2.0) - glm::dvec3(-2, 0, 0)), 0.0, 1e-12);
}

TEST(Scene, FigureStaysTogetherAsItWalks) {
    // Where two limbs meet they share a joint: each hand is 26 cm and a little from its elbow at any time.
    const Scene loaded = loadScene("figure");
    const auto centerOf = [](const Scene& scene, const std::string& mesh) {
        Bounds bounds;
        for (const Instance& instance : scene.instances)
            if (scene.meshes[std::size_t(instance.mesh)].name == mesh)
                for (const glm::vec3& p : scene.meshes[std::size_t(instance.mesh)].positions) {
                    const glm::dvec3 p_world(instance.worldFromLocal * glm::dvec4(p, 1.0));
                    bounds.lower = glm::min(bounds.lower, p_world);
                    bounds.upper = glm::max(bounds.upper, p_world);
                }
        return bounds.center();
    };
    double farthest = 0;
    for (const double time_s : {0.0, 0.15, 0.3, 0.6, 0.9, 1.1}) {
        Scene scene = loaded;
        animate(scene, time_s);
        for (const std::string side : {"left ", "right "}) {
            // Centres of bounds of turned limbs wander by some centimetres.
            EXPECT_NEAR(glm::length(centerOf(scene, side + "hand") - centerOf(scene, side + "forearm")), 0.16, 0.05);
            EXPECT_NEAR(glm::length(centerOf(scene, side + "foot") - centerOf(scene, side + "shin")), 0.24, 0.08);
        }
        farthest = std::max(farthest, glm::length(centerOf(scene, "left foot") - centerOf(loaded, "left foot")));
    }
    EXPECT_GT(farthest, 0.3);
    // A whole period later it stands as before; sines of 2 pi are good to 1e-15.
    Scene again = loaded;
    animate(again, 1.2);
    EXPECT_NEAR(glm::length(centerOf(again, "left hand") - centerOf(loaded, "left hand")), 0.0, 1e-12);
}

TEST(Light, AxesArePerpendicularAndSizesAreKnown) {
    Light light;
    for (const glm::vec3 direction : {glm::vec3(0, -1, 0), glm::vec3(0.6f, -0.8f, 0.0f), glm::vec3(0, 0, 1)}) {
        light.direction = direction;
        const glm::vec3 t = lightTangent(light), b = lightBitangent(light);
        EXPECT_NEAR(glm::length(t), 1.0f, 1e-6f);  // float roundings
        EXPECT_NEAR(glm::dot(t, direction), 0.0f, 1e-6f);
        EXPECT_NEAR(glm::length(b - glm::cross(direction, t)), 0.0f, 1e-6f);
    }
    light.type = LightType::Point;
    light.angle_rad = 1.0f;
    EXPECT_FALSE(light.hasSize());
    light.radius_m = 0.1f;
    EXPECT_TRUE(light.hasSize());
    light.type = LightType::Rect;
    EXPECT_FALSE(light.hasSize());
    light.size_m = {0.0f, 1.0f};
    EXPECT_TRUE(light.hasSize());
}

glm::vec3 faceNormal(const FlatScene& flat, const glm::uvec3& t) {
    const glm::vec3 a = flat.positions[t.x];
    return glm::normalize(glm::cross(flat.positions[t.y] - a, flat.positions[t.z] - a));
}

TEST(FlatScene, MirroredInstancesKeepTheirOutside) {
    Scene scene = loadScene("sphere");
    for (const glm::dvec3 scale :
         {glm::dvec3(1, 1, 1), glm::dvec3(-1, 1, 1), glm::dvec3(-2, 0.5, -1), glm::dvec3(-1, -3, -1)}) {
        scene.instances[1].worldFromLocal = glm::scale(glm::dmat4(1.0), scale);
        const FlatScene flat = flatten(scene);
        const FlatInstance& sphere = flat.instances[1];
        EXPECT_EQ(sphere.mirrored, scale.x * scale.y * scale.z < 0.0);
        for (std::uint32_t i = 0; i < sphere.triangleCount; ++i) {
            const glm::uvec3 t = flat.triangles[sphere.firstTriangle + i];
            ASSERT_GT(glm::dot(faceNormal(flat, t), flat.normals[t.x]), 0.0f);
            ASSERT_EQ(flat.triangleInstance[sphere.firstTriangle + i], 1u);
        }
        for (std::uint32_t v = sphere.firstVertex; v < sphere.firstVertex + sphere.vertexCount; ++v) {
            // Unit and perpendicular to a few float roundings.
            ASSERT_NEAR(glm::length(flat.normals[v]), 1.0f, 1e-5f);
            ASSERT_NEAR(glm::dot(glm::vec3(flat.tangents[v]), flat.normals[v]), 0.0f, 1e-5f);
        }
    }
}

TEST(FlatScene, MirroringTurnsTheBitangentWithTheSurface) {
    Scene scene = loadScene("gap");
    scene.instances[1].worldFromLocal = glm::scale(glm::dmat4(1.0), glm::dvec3(1, 1, -1));
    const FlatScene flat = flatten(scene);
    const Mesh& mesh = scene.meshes[1];
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3 bitangent = mesh.tangents[i].w * glm::cross(mesh.normals[i], glm::vec3(mesh.tangents[i]));
        const std::size_t v = flat.instances[1].firstVertex + i;
        const glm::vec3 flatBitangent = flat.tangents[v].w * glm::cross(flat.normals[v], glm::vec3(flat.tangents[v]));
        EXPECT_NEAR(glm::length(flatBitangent - bitangent * glm::vec3(1, 1, -1)), 0.0f, 1e-6f);
    }
}

TEST(FlatScene, FarFromTheOriginLosesNothing) {
    Scene scene = loadScene("gap");
    const FlatScene near = flatten(scene);
    for (Instance& instance : scene.instances) instance.worldFromLocal[3] += glm::dvec4(5000, 0, -5000, 0);
    const FlatScene far = flatten(scene);
    ASSERT_EQ(near.positions.size(), far.positions.size());
    // A double at 5 km is good to 1e-12 m, a float at 3 m to 2.4e-7.
    for (std::size_t i = 0; i < near.positions.size(); ++i)
        ASSERT_NEAR(glm::length(near.positions[i] - far.positions[i]), 0.0f, 5e-7f);
}

TEST(CameraView, RaysAndMatricesAgree) {
    Scene scene = loadScene("room");
    scene.cameras[1].orthoHeight_m = 3.0f;
    const Bounds bounds = scene.bounds();
    const glm::dvec3 origin = bounds.center();
    for (const Camera& camera : scene.cameras) {
        const CameraView view = makeCameraView(camera, 640, 360, origin, bounds);
        for (const glm::dvec2 pixel : {glm::dvec2(0.5, 0.5), glm::dvec2(320, 180), glm::dvec2(600.25, 17.75)}) {
            glm::dvec3 start, direction;
            view.ray(pixel.x, pixel.y, start, direction);
            EXPECT_NEAR(glm::length(direction), 1.0, 1e-12);
            const glm::dvec3 p = start + 4.0 * direction;
            const glm::vec4 clip = view.clipFromWorld * glm::vec4(glm::vec3(p), 1.0f);
            // Float matrices at a few metres: 1e-6 of the picture's width, less than a thousandth of a pixel.
            EXPECT_NEAR((clip.x / clip.w * 0.5 + 0.5) * 640, pixel.x, 2e-3);
            EXPECT_NEAR((0.5 - clip.y / clip.w * 0.5) * 360, pixel.y, 2e-3);
            const double depth_m = glm::dot(p - glm::dvec3(view.eye), glm::dvec3(view.forward));
            if (view.orthographic)
                EXPECT_NEAR(clip.z / clip.w, 1.0 - (depth_m - view.near_m) / (view.far_m - view.near_m), 1e-5);
            else
                EXPECT_NEAR(clip.z / clip.w, view.near_m / depth_m, 1e-8);
        }
        const glm::mat4 identity = view.viewFromWorld * view.worldFromView;
        for (int i = 0; i < 4; ++i) EXPECT_NEAR(glm::length(identity[i] - glm::mat4(1.0f)[i]), 0.0f, 1e-5f);
    }
}

TEST(CameraView, InfinitelyFarPointsHaveDepthZero) {
    const Scene scene = loadScene("gap");
    const CameraView view = makeCameraView(scene.cameras[0], 64, 36, scene.bounds().center(), scene.bounds());
    const glm::vec4 clip = view.clipFromView * glm::vec4(0, 0, -1, 0);
    EXPECT_EQ(clip.z, 0.0f);
    EXPECT_EQ(clip.w, 1.0f);
}

TEST(CameraView, LooksStraightDown) {
    Camera camera;
    camera.position = {0, 5, 0};
    camera.target = {0, 0, 0};
    const CameraView view = makeCameraView(camera, 64, 64, glm::dvec3(0.0), Bounds{});
    EXPECT_NEAR(glm::length(view.right), 1.0f, 1e-6f);
    EXPECT_NEAR(glm::dot(view.up, view.forward), 0.0f, 1e-6f);
    camera.target = camera.position;
    EXPECT_THROW(makeCameraView(camera, 64, 64, glm::dvec3(0.0), Bounds{}), Error);
}

}  // namespace
}  // namespace ombrage
