// SPDX-License-Identifier: MIT
#include "scene/planar_surfaces.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace ombrage {
namespace {

/// A grid of cells x cells squares in the xz plane, `size_m` wide, facing up.
Mesh grid(int cells, float size_m) {
    Mesh mesh;
    for (int z = 0; z <= cells; ++z)
        for (int x = 0; x <= cells; ++x)
            mesh.positions.emplace_back(size_m * (float(x) / float(cells) - 0.5f), 0.0f,
                                        size_m * (float(z) / float(cells) - 0.5f));
    const auto at = [&](int x, int z) { return std::uint32_t(z * (cells + 1) + x); };
    for (int z = 0; z < cells; ++z)
        for (int x = 0; x < cells; ++x)
            mesh.indices.insert(mesh.indices.end(),
                                {at(x, z), at(x, z + 1), at(x + 1, z + 1), at(x, z), at(x + 1, z + 1), at(x + 1, z)});
    mesh.normals.assign(mesh.positions.size(), glm::vec3(0, 1, 0));
    mesh.tangents.assign(mesh.positions.size(), glm::vec4(1, 0, 0, 1));
    mesh.uvs.assign(mesh.positions.size(), glm::vec2(0));
    return mesh;
}

void add(Scene& scene, const Mesh& mesh, const glm::dmat4& worldFromLocal) {
    if (scene.materials.empty()) scene.materials.emplace_back();
    scene.meshes.push_back(mesh);
    scene.models.emplace_back();
    Instance instance;
    instance.mesh = int(scene.meshes.size()) - 1;
    instance.model = int(scene.models.size()) - 1;
    instance.worldFromLocal = worldFromLocal;
    scene.instances.push_back(instance);
}

glm::dmat4 moved(const glm::dvec3& by) {
    glm::dmat4 m(1.0);
    m[3] = glm::dvec4(by, 1.0);
    return m;
}

TEST(PlanarSurfaces, AFloorComesBeforeALargerWall) {
    Scene scene;
    add(scene, grid(1, 2.0f), moved({0, 0.5, 0}));
    const glm::dmat4 upright(glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 0, 1, 0), glm::dvec4(0, -1, 0, 0),
                             glm::dvec4(0, 2, -3, 1));
    add(scene, grid(1, 4.0f), upright);
    const FlatScene flat = flatten(scene);
    const PlanarSurfaces found = findPlanarSurfaces(flat);
    ASSERT_EQ(found.planes.size(), 2u);
    EXPECT_NEAR(found.planes[0].normal.y, 1.0, 1e-9);
    EXPECT_NEAR(found.planes[0].offset_m, 0.5 - flat.origin.y, 1e-6);
    EXPECT_NEAR(found.area_m2[0], 4.0, 1e-5);
    EXPECT_NEAR(found.planes[1].normal.z, 1.0, 1e-9);
    EXPECT_NEAR(found.area_m2[1], 16.0, 1e-5);
    EXPECT_EQ(found.planeOf, (std::vector<std::uint8_t>{1, 1, 2, 2}));
}

// 1 mm is 26 tolerances in a scene of 20 m, and far less than the cells in which planes are looked for.
TEST(PlanarSurfaces, PlanesAMillimetreApartAreTwo) {
    Scene scene;
    add(scene, grid(1, 20.0f), moved({0, 0, 0}));
    add(scene, grid(1, 10.0f), moved({0, 0.001, 0}));
    const PlanarSurfaces found = findPlanarSurfaces(flatten(scene));
    ASSERT_EQ(found.planes.size(), 2u);
    EXPECT_EQ(found.planeOf, (std::vector<std::uint8_t>{1, 1, 2, 2}));
}

// 20,000 small triangles, turned about a skew axis: each alone has a normal too rough to reach the others.
TEST(PlanarSurfaces, AFineGridIsOnePlaneHoweverItLies) {
    Scene scene;
    glm::dmat4 turned(1.0);
    const glm::dvec3 up = glm::normalize(glm::dvec3(0.31, 0.83, -0.46)),
                     side = glm::normalize(glm::cross(up, glm::dvec3(0.2, 0.1, 0.9)));
    turned[0] = glm::dvec4(side, 0);
    turned[1] = glm::dvec4(up, 0);
    turned[2] = glm::dvec4(glm::cross(side, up), 0);
    turned[3] = glm::dvec4(3, -2, 5, 1);
    add(scene, grid(100, 30.0f), turned);
    add(scene, grid(1, 6.0f), moved({4, 9, 3}));
    const PlanarSurfaces found = findPlanarSurfaces(flatten(scene));
    // 36 of 936 square metres are over a 50th; lying flat, the small one is the floor.
    ASSERT_EQ(found.planes.size(), 2u);
    EXPECT_EQ(std::count(found.planeOf.begin(), found.planeOf.end(), std::uint8_t(2)), 20000);
    EXPECT_GT(glm::dot(found.planes[1].normal, up), 1 - 1e-12);
}

TEST(PlanarSurfaces, ABallHasNoneAndWhatReceivesNothingIsNone) {
    Scene scene;
    Mesh curved = grid(60, 10.0f);
    for (glm::vec3& p : curved.positions) p.y = 0.05f * (p.x * p.x + p.z * p.z);
    add(scene, curved, moved({0, 0, 0}));
    EXPECT_TRUE(findPlanarSurfaces(flatten(scene)).planes.empty());
    add(scene, grid(1, 10.0f), moved({0, 0, 0}));
    EXPECT_EQ(findPlanarSurfaces(flatten(scene)).planes.size(), 1u);
    scene.models[1].receives = false;
    EXPECT_TRUE(findPlanarSurfaces(flatten(scene)).planes.empty());
}

}  // namespace
}  // namespace ombrage
