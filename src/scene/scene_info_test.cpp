// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <ombrage/scene_info.h>

#include "scene/scene_builder.h"
#include "scene/shapes.h"

namespace ombrage {
namespace {

Scene sceneOf(Mesh mesh) {
    return SceneBuilder("test").object("thing", std::move(mesh), glm::vec3(0.5f)).finish(1.0f);
}

MeshInfo infoOf(Mesh mesh) {
    return describeScene(sceneOf(std::move(mesh))).meshes.at(0);
}

TEST(SceneInfo, ABoxIsClosedThoughItsFacesShareNoVertex) {
    const MeshInfo info = infoOf(shapes::box({0, 0, 0}, {1, 1, 1}));
    EXPECT_EQ(info.shape, MeshShape::Closed);
    EXPECT_EQ(info.triangles, 12u);
    EXPECT_EQ(info.vertices, 24u);
    EXPECT_EQ(info.edges, 18u);  // 12 of the cube and 6 diagonals
    EXPECT_EQ(info.openEdges, 0u);
    EXPECT_TRUE(info.boundsVolume());
}

TEST(SceneInfo, ABoxWithoutATriangleIsOpen) {
    Mesh mesh = shapes::box({0, 0, 0}, {1, 1, 1});
    mesh.indices.resize(33);
    const MeshInfo info = infoOf(mesh);
    EXPECT_EQ(info.shape, MeshShape::Open);
    EXPECT_EQ(info.openEdges, 3u);
    EXPECT_EQ(info.nonManifoldEdges, 0u);
}

TEST(SceneInfo, SharedAndTwistedEdgesAreNonManifold) {
    // Two boxes that share an edge bound volumes all the same.
    Mesh mesh = shapes::box({0, 0, 0}, {1, 1, 1});
    const Mesh other = shapes::box({1, 1, 0}, {2, 2, 1});
    const auto first = std::uint32_t(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
    mesh.normals.insert(mesh.normals.end(), other.normals.begin(), other.normals.end());
    mesh.uvs.insert(mesh.uvs.end(), other.uvs.begin(), other.uvs.end());
    for (const std::uint32_t index : other.indices) mesh.indices.push_back(first + index);
    const MeshInfo shared = infoOf(mesh);
    EXPECT_EQ(shared.shape, MeshShape::NonManifold);
    EXPECT_EQ(shared.nonManifoldEdges, 1u);
    EXPECT_TRUE(shared.boundsVolume());

    // A triangle that is turned over runs the same way as its three neighbours.
    Mesh twisted = shapes::box({0, 0, 0}, {1, 1, 1});
    std::swap(twisted.indices[0], twisted.indices[1]);
    const MeshInfo info = infoOf(twisted);
    EXPECT_EQ(info.shape, MeshShape::NonManifold);
    EXPECT_EQ(info.nonManifoldEdges, 3u);
    EXPECT_FALSE(info.boundsVolume());
}

TEST(SceneInfo, CountsOverInstances) {
    Scene scene = sceneOf(shapes::box({0, 0, 0}, {1, 2, 3}));
    scene.instances.push_back(scene.instances[0]);
    const SceneInfo info = describeScene(scene);
    EXPECT_EQ(info.triangles, 24u);
    EXPECT_EQ(info.vertices, 48u);
    EXPECT_EQ(info.meshes[0].instances, 2u);
    EXPECT_EQ(info.meshes[0].model, "thing");
    EXPECT_EQ(info.contentHash, contentHash(scene));
}

TEST(SceneInfo, ColorsChangeTheContent) {
    Scene scene = sceneOf(shapes::box({0, 0, 0}, {1, 1, 1}));
    const std::string plain = contentHash(scene);
    scene.meshes[0].colors.assign(scene.meshes[0].positions.size(), glm::vec3(0.5f));
    EXPECT_NE(contentHash(scene), plain);
    EXPECT_TRUE(describeScene(scene).meshes[0].hasColors);
}

}  // namespace
}  // namespace ombrage
