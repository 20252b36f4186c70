// SPDX-License-Identifier: MIT
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include <gtest/gtest.h>
#include <ombrage/error.h>
#include <ombrage/scene.h>

#include "scene/camera_view.h"
#include "scene/flat_scene.h"
#include "scene/shapes.h"

namespace ombrage {
namespace {

using Key = std::tuple<float, float, float>;

/// Edges that do not meet exactly one edge running the other way, corners welded by position (an edge over a fan of
/// touching boxes may be met several times, equally often in both directions).
std::size_t openEdgeCount(const Mesh& mesh) {
    std::map<Key, int> numbers;
    std::vector<int> number;
    for (const glm::vec3& p : mesh.positions)
        number.push_back(numbers.try_emplace(Key{p.x, p.y, p.z}, int(numbers.size())).first->second);
    std::map<std::pair<int, int>, int> edges;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const int a = number[mesh.indices[i]], b = number[mesh.indices[i % 3 == 2 ? i - 2 : i + 1]];
        ++edges[{a, b}];
    }
    std::size_t open = 0;
    for (const auto& [edge, count] : edges) {
        const auto back = edges.find({edge.second, edge.first});
        if (count != 1 || back == edges.end() || back->second != 1) ++open;
    }
    return open;
}

double signedVolume(const Mesh& mesh) {
    double volume = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 a(mesh.positions[mesh.indices[i]]), b(mesh.positions[mesh.indices[i + 1]]),
            c(mesh.positions[mesh.indices[i + 2]]);
        volume += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
    return volume;
}

bool isOpenOnPurpose(const std::string& mesh) {
    static const std::set<std::string> open = {"floor",      "half tube", "bowl",    "disk",   "back wall", "left wall",
                                               "right wall", "ceiling",   "lattice", "leaves", "hair"};
    return open.count(mesh) > 0;
}

class Builtin : public testing::TestWithParam<std::string> {};

TEST_P(Builtin, ClosedMeshesAreClosedAndLookOutwards) {
    const Scene scene = loadScene(GetParam());
    for (const Mesh& mesh : scene.meshes) {
        if (isOpenOnPurpose(mesh.name)) {
            EXPECT_GT(openEdgeCount(mesh), 0u) << mesh.name;
            continue;
        }
        EXPECT_EQ(openEdgeCount(mesh), 0u) << mesh.name;
        if (mesh.name == "walls")
            EXPECT_LT(signedVolume(mesh), 0.0);
        else
            EXPECT_GT(signedVolume(mesh), 0.0) << mesh.name;
    }
}

TEST_P(Builtin, IsAValidScene) {
    const Scene scene = loadScene(GetParam());
    EXPECT_EQ(scene.name, GetParam());
    EXPECT_FALSE(scene.description.empty());
    ASSERT_EQ(scene.cameras.size(), 3u);
    EXPECT_EQ(scene.cameras[0].name, "main");
    EXPECT_EQ(scene.cameras[1].name, "left");
    EXPECT_EQ(scene.cameras[2].name, "top");
    EXPECT_GT(scene.aoRadius_m, 0.0f);
    std::set<int> usedModels;
    for (const Instance& instance : scene.instances) usedModels.insert(instance.model);
    EXPECT_EQ(usedModels.size(), scene.models.size());
    for (const Light& light : scene.lights) {
        EXPECT_EQ(light.hasSize(), scene.name == "area-overlap" || scene.name == "penumbrae");
        EXPECT_NEAR(glm::length(light.direction), 1.0f, 1e-6f);  // a few float roundings
    }
    for (const Mesh& mesh : scene.meshes) {
        ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
        ASSERT_EQ(mesh.tangents.size(), mesh.positions.size());
        ASSERT_EQ(mesh.uvs.size(), mesh.positions.size());
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            const glm::vec3 t(mesh.tangents[i]);
            // Unit vectors after a few float operations.
            ASSERT_NEAR(glm::length(mesh.normals[i]), 1.0f, 1e-5f) << mesh.name;
            ASSERT_NEAR(glm::length(t), 1.0f, 1e-5f) << mesh.name;
            ASSERT_NEAR(glm::dot(t, mesh.normals[i]), 0.0f, 1e-5f) << mesh.name;
            ASSERT_EQ(std::abs(mesh.tangents[i].w), 1.0f) << mesh.name;
        }
        // The normals lie on the side that the winding shows.
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const glm::vec3 a = mesh.positions[mesh.indices[i]], b = mesh.positions[mesh.indices[i + 1]],
                            c = mesh.positions[mesh.indices[i + 2]];
            ASSERT_GT(glm::dot(glm::cross(b - a, c - a), mesh.normals[mesh.indices[i]]), 0.0f) << mesh.name;
        }
    }
}

TEST_P(Builtin, CamerasSeeEnoughOfIt) {
    const Scene scene = loadScene(GetParam());
    const FlatScene flat = flatten(scene);
    const Bounds bounds = scene.bounds();
    for (const Camera& camera : scene.cameras) {
        // A 32 x 18 grid stands for 640 x 360 pixels, 400 to one.
        const CameraView view = makeCameraView(camera, 32, 18, flat.origin, bounds);
        int hits = 0;
        for (int y = 0; y < view.height; ++y)
            for (int x = 0; x < view.width; ++x) {
                glm::dvec3 start, direction;
                view.ray(x + 0.5, y + 0.5, start, direction);
                if (std::isfinite(nearestHit(flat, start, direction))) ++hits;
            }
        EXPECT_GE(hits * 400, 10000) << camera.name;
    }
}

std::vector<std::string> builtinNames() {
    std::vector<std::string> names;
    for (const BuiltinScene& scene : builtinScenes()) names.push_back(scene.name);
    return names;
}

std::string testName(const testing::TestParamInfo<std::string>& info) {
    std::string name = info.param;
    for (char& c : name)
        if (c == '-') c = '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(All, Builtin, testing::ValuesIn(builtinNames()), testName);

TEST(BuiltinScenes, UnknownNameSuggestsTheNearest) {
    try {
        loadScene("mengre");
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Usage);
        EXPECT_NE(error.hint().find("menger"), std::string::npos) << error.hint();
    }
}

TEST(BuiltinScenes, InShadowCamerasStandInTheShadow) {
    const Scene scene = loadScene("in-shadow");
    const FlatScene flat = flatten(scene);
    for (const char* name : {"main", "left"}) {
        const Camera& camera = scene.cameras[std::size_t(scene.cameraIndex(name))];
        EXPECT_TRUE(
            std::isfinite(nearestHit(flat, camera.position - flat.origin, -glm::dvec3(scene.lights[0].direction))));
    }
    EXPECT_FALSE(std::isfinite(
        nearestHit(flat, scene.cameras[2].position - flat.origin, -glm::dvec3(scene.lights[0].direction))));
}

TEST(BuiltinScenes, MengerHasOnlyTheFacesOutside) {
    const Scene scene = loadScene("menger");
    // 2 * 20^3 + 4 * 8^3 faces of a level-3 sponge, two triangles each.
    EXPECT_EQ(scene.meshes[1].triangleCount(), 2u * (2u * 8000u + 4u * 512u));
    // Volume (20/27)^3 of the cube of 2 m; float corners are good to 1e-6 of it.
    EXPECT_NEAR(signedVolume(scene.meshes[1]), 8.0 * std::pow(20.0 / 27.0, 3), 1e-5);
}

TEST(BuiltinScenes, GapIsOneMillimetre) {
    const Scene scene = loadScene("gap");
    float lowest = 1e9f;
    for (const glm::vec3& p : scene.meshes[1].positions) lowest = std::min(lowest, p.y);
    EXPECT_EQ(lowest, 0.001f);
}

TEST(BuiltinScenes, GrazingSunIsFourDegreesUp) {
    const Scene scene = loadScene("plane-grazing");
    // A float sine is good to 1e-7; that is 6e-6 degrees here.
    EXPECT_NEAR(glm::degrees(std::asin(-scene.lights[0].direction.y)), 4.0f, 1e-4f);
}

TEST(Shapes, VolumesAndAreasMeetTheirFormulas) {
    // Inscribed polygons: a 64-gon prism holds 1 - 0.16 % of the cylinder, a 64 x 32 sphere 1 - 0.48 % of the ball.
    EXPECT_NEAR(signedVolume(shapes::cylinder({1, 2, 3}, 0.5f, 2.0f, 64)), 1.5708, 0.003);
    EXPECT_NEAR(signedVolume(shapes::sphere({1, 2, 3}, 1.0f)), 4.18879, 0.021);
    EXPECT_NEAR(signedVolume(shapes::box({1, 1, 1}, {2, 3, 4})), 6.0, 1e-6);
    EXPECT_NEAR(signedVolume(shapes::box({1, 1, 1}, {2, 3, 4}, true)), -6.0, 1e-6);
}

}  // namespace
}  // namespace ombrage
