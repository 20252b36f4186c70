// SPDX-License-Identifier: MIT
#include <chrono>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <ombrage/scene.h>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/builtin.h"
#include "scene/scene_repair.h"
#include "scene/shapes.h"

namespace ombrage {
namespace {

Scene sceneOf(Mesh mesh) {
    Scene scene;
    mesh.name = "mesh";
    mesh.tangents.assign(mesh.positions.size(), glm::vec4(1, 0, 0, 1));
    scene.meshes.push_back(std::move(mesh));
    return scene;
}

TEST(SceneRepair, LeavesSoundScenesAlone) {
    for (const char* name : {"gap", "menger", "tree", "mirrored"}) {
        const Scene before = makeBuiltinScene(name);
        Scene after = before;
        repairScene(after);
        EXPECT_EQ(contentHash(after), contentHash(before)) << name;
        EXPECT_TRUE(after.warnings.empty()) << name;
    }
}

TEST(SceneRepair, DropsDuplicatesByPlaceAndTurningSense) {
    // Triangle 0 1 2 again: from its second corner on, and with other vertices at the same places; then its back side
    // and its neighbour, which stay.
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    mesh.normals.assign(7, {0, 0, 1});
    mesh.uvs.assign(7, {0, 0});
    mesh.indices = {0, 1, 2, 1, 2, 0, 3, 4, 5, 0, 2, 1, 1, 6, 2};
    Scene scene = sceneOf(mesh);
    repairScene(scene);
    EXPECT_EQ(scene.meshes[0].triangleCount(), 3u);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0], "2 triangles that are there twice left out (in mesh)");
}

TEST(SceneRepair, FansOfManyTrianglesTakeNoLongerThanOthers) {
    // 200,000 triangles share a corner: each compared with each would take some 20 s, a table 0.1 s.
    Mesh mesh;
    constexpr std::uint32_t kCount = 200000;
    mesh.positions.emplace_back(0.0f);
    for (std::uint32_t i = 0; i <= kCount; ++i)
        mesh.positions.emplace_back(1000.0f * std::cos(3e-5f * float(i)), 1000.0f * std::sin(3e-5f * float(i)), 0.0f);
    mesh.normals.assign(mesh.positions.size(), {0, 0, 1});
    mesh.uvs.assign(mesh.positions.size(), {0, 0});
    for (std::uint32_t i = 0; i < kCount; ++i) mesh.indices.insert(mesh.indices.end(), {0, i + 1, i + 2});
    mesh.indices.insert(mesh.indices.end(), {2, 0, 1});
    Scene scene = sceneOf(mesh);
    const auto start = std::chrono::steady_clock::now();
    repairScene(scene);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0], "1 triangle that are there twice left out (in mesh)");
}

TEST(SceneRepair, DropsInstancesThatNoPictureTellsApart) {
    Scene scene = sceneOf(shapes::box({0, 0, 0}, {1, 1, 1}));
    scene.meshes.resize(3, scene.meshes[0]);
    for (Mesh& mesh : scene.meshes) mesh.tangents = scene.meshes[0].tangents;
    scene.meshes[1].material = 1;  // another name, the same look
    scene.meshes[2].material = 2;  // another look
    scene.materials.resize(3);
    scene.materials[1].name = "twin";
    scene.materials[2].baseColor = {1, 0, 0};
    scene.models.resize(2);
    const glm::dmat4 moved = glm::translate(glm::dmat4(1.0), {1, 0, 0});
    scene.instances = {{0, 0, glm::dmat4(1.0)}, {1, 0, glm::dmat4(1.0)}, {2, 0, glm::dmat4(1.0)},
                       {0, 0, glm::dmat4(1.0)}, {0, 1, glm::dmat4(1.0)}, {0, 0, moved}};
    Scene animated = scene;
    repairScene(scene);
    ASSERT_EQ(scene.instances.size(), 4u);
    EXPECT_EQ(scene.instances[1].mesh, 2);
    EXPECT_EQ(scene.instances[2].model, 1);
    EXPECT_EQ(scene.instances[3].worldFromLocal, moved);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0], "2 parts that repeat another at the same place left out");
    // An animation may take them apart.
    animated.animations.push_back({.type = "swing", .instances = {3}});
    repairScene(animated);
    EXPECT_EQ(animated.instances.size(), 6u);
}

TEST(SceneRepair, SaysWhatItDropsAndMakesNumbersOfTheRest) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), endless = std::numeric_limits<float>::infinity();
    Mesh mesh = shapes::box({0, 0, 0}, {1, 1, 1});
    mesh.positions.push_back({nan, 0, 0});
    mesh.positions.push_back({0, endless, 0});
    mesh.normals.insert(mesh.normals.end(), 2, {0, 0, 1});
    mesh.uvs.insert(mesh.uvs.end(), 2, {0, 0});
    mesh.normals[0].x = nan;
    mesh.uvs[1].y = endless;
    mesh.indices.insert(mesh.indices.end(), {0, 1, 24, 0, 25, 1, 0, 1, 1});
    Scene scene = sceneOf(mesh);
    repairScene(scene);
    const Mesh& repaired = scene.meshes[0];
    EXPECT_EQ(repaired.triangleCount(), 12u);
    for (std::size_t v = 0; v < repaired.positions.size(); ++v) {
        EXPECT_TRUE(std::isfinite(repaired.positions[v].x + repaired.positions[v].y)) << "a vertex that nobody needs";
        EXPECT_NEAR(glm::length(repaired.normals[v]), 1.0f, 1e-6f);  // float roundings
        EXPECT_NEAR(glm::length(glm::vec3(repaired.tangents[v])), 1.0f, 1e-6f);
        EXPECT_TRUE(std::isfinite(repaired.uvs[v].x + repaired.uvs[v].y));
    }
    ASSERT_EQ(scene.warnings.size(), 2u);
    EXPECT_EQ(scene.warnings[1], "3 triangles with non-finite corners or without area left out (in mesh)");
}

TEST(SceneRepair, DegenerateLosesExactlyWhatWasSpoilt) {
    const Scene raw = makeBuiltinScene("degenerate"), repaired = loadScene("degenerate");
    // Of every 20th of the sound triangles four spoilt ones were made: a floor of 128, a ball of 2208, a block of 12.
    const std::size_t sound = 128 + 2208 + 12, spoilt = 4 * (7 + 111 + 1);
    EXPECT_EQ(raw.triangleCount(), sound + spoilt);
    EXPECT_EQ(repaired.triangleCount(), sound);
    ASSERT_EQ(repaired.warnings.size(), 2u);
    EXPECT_EQ(repaired.warnings[0],
              "357 triangles with non-finite corners or without area left out (in floor, ball, block)");
    EXPECT_EQ(repaired.warnings[1], "119 triangles that are there twice left out (in floor, ball, block)");
    const Bounds bounds = raw.bounds();
    EXPECT_EQ(bounds.lower, repaired.bounds().lower);
    EXPECT_EQ(bounds.upper, repaired.bounds().upper);
}

}  // namespace
}  // namespace ombrage
