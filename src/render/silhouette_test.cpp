// SPDX-License-Identifier: MIT
#include "techniques/shared/silhouette.h"

#include <limits>

#include <gtest/gtest.h>

namespace ombrage {
namespace {

/// A unit cube about the zero with its own four corners per face, as a loader makes it.
Mesh cube() {
    Mesh mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (float side : {-0.5f, 0.5f}) {
            const auto first = std::uint32_t(mesh.positions.size());
            for (int k = 0; k < 4; ++k) {
                glm::vec3 p(0);
                p[axis] = side;
                p[(axis + 1) % 3] = k == 1 || k == 2 ? 0.5f : -0.5f;
                p[(axis + 2) % 3] = k >= 2 ? 0.5f : -0.5f;
                mesh.positions.push_back(p);
            }
            const std::uint32_t order[2][6] = {{0, 2, 1, 0, 3, 2}, {0, 1, 2, 0, 2, 3}};
            for (std::uint32_t i : order[side > 0 ? 1 : 0]) mesh.indices.push_back(first + i);
        }
    return mesh;
}

VolumeTriangles volumeOf(const Mesh& mesh, VolumeRequest request) {
    VolumeTriangles out;
    appendVolume(MeshTopology(mesh), request, out);
    return out;
}

const glm::dvec4 kSunAbove(0.1, 1.0, 0.2, 0.0);   // sees three faces
const glm::dvec4 kLampAbove(0.0, 3.0, 0.0, 1.0);  // sees the top alone

TEST(Silhouette, CubeOfSeparateFacesIsClosedAndACubeWithAHoleIsNot) {
    Mesh mesh = cube();
    EXPECT_TRUE(MeshTopology(mesh).closed());
    EXPECT_EQ(MeshTopology(mesh).edgeCount(), 18u);  // 12 and a diagonal per face
    mesh.indices.resize(mesh.indices.size() - 3);
    EXPECT_FALSE(MeshTopology(mesh).closed());
    EXPECT_EQ(MeshTopology(mesh).openEdgeCount(), 3u);
}

TEST(Silhouette, SunSidesAreSingleTrianglesWithoutAFarCap) {
    // Three faces seen: a hexagon of 6 edges; 6 triangles turned away.
    const VolumeTriangles v = volumeOf(cube(), {.light_local = kSunAbove});
    EXPECT_EQ(v.edges, 6u);
    EXPECT_EQ(v.sides.size() / 3, 6u);
    EXPECT_EQ(v.inwardLightCaps.size() / 3, 6u);
    EXPECT_TRUE(v.lightCaps.empty());
    EXPECT_TRUE(v.darkCaps.empty());
    // Where they end after all, they have four corners and a cap.
    const VolumeTriangles ended = volumeOf(cube(), {.light_local = kSunAbove, .finite = true});
    EXPECT_EQ(ended.sides.size() / 3, 12u);
    EXPECT_EQ(ended.darkCaps.size() / 3, 6u);
}

TEST(Silhouette, LampSidesAreQuadsAndCapsComeTwice) {
    // The top is seen: its 4 edges; 10 triangles turned away, each also at infinity.
    const VolumeTriangles v = volumeOf(cube(), {.light_local = kLampAbove});
    EXPECT_EQ(v.edges, 4u);
    EXPECT_EQ(v.sides.size() / 3, 4u * 2);
    EXPECT_EQ(v.inwardLightCaps.size() / 3, 10u);
    EXPECT_EQ(v.darkCaps.size() / 3, 10u);
    for (std::uint32_t code : v.inwardLightCaps) EXPECT_EQ(code & 1u, 0u);
    for (std::uint32_t code : v.darkCaps) EXPECT_EQ(code & 1u, 1u);
}

TEST(Silhouette, LitTrianglesAloneBoundTheSameVolumeOfAClosedMesh) {
    // The other side of the same silhouette: 4 edges run the same way, and the 2 triangles of the top cast.
    const VolumeTriangles away = volumeOf(cube(), {.light_local = kLampAbove}),
                          lit = volumeOf(cube(), {.light_local = kLampAbove, .litOnly = true});
    EXPECT_EQ(lit.edges, 4u);
    EXPECT_EQ(lit.sides, away.sides);
    EXPECT_EQ(lit.lightCaps.size() / 3, 2u);
    EXPECT_TRUE(lit.inwardLightCaps.empty());
}

TEST(Silhouette, TriangleFacesOfAClosedMeshAreCountedOncePerSide) {
    EXPECT_EQ(volumeOf(cube(), {.light_local = kLampAbove, .faces = VolumeFaces::Facing}).edges, 30u);  // 10 triangles
    EXPECT_EQ(volumeOf(cube(), {.light_local = kLampAbove, .faces = VolumeFaces::All}).edges, 36u);
}

TEST(Silhouette, OpenMeshCountsItsBorderOnceAndItsFoldTwice) {
    // A roof of two triangles about the ridge along z, wound upwards.
    Mesh roof;
    roof.positions = {{0, 1, -1}, {0, 1, 1}, {1, 0, 0}, {-1, 0, 0}};
    roof.indices = {0, 1, 2, 1, 0, 3};
    EXPECT_FALSE(MeshTopology(roof).closed());
    EXPECT_EQ(MeshTopology(roof).edgeCount(), 5u);
    const auto edges = [&](const glm::dvec4& light_local) {
        return volumeOf(roof, {.light_local = light_local, .both = true}).edges;
    };
    // From above both face the light, and the ridge cancels; from the side one shows its back, and the ridge bounds
    // both.
    EXPECT_EQ(edges({0, 9, 0, 1}), 4u);
    EXPECT_EQ(edges({9, 0.5, 0, 1}), 6u);
}

TEST(Silhouette, TrianglesWithoutAPlaceAreLeftOut) {
    Mesh mesh = cube();
    mesh.positions.push_back(glm::vec3(std::numeric_limits<float>::quiet_NaN()));
    const auto nan = std::uint32_t(mesh.positions.size()) - 1;
    mesh.indices.insert(mesh.indices.end(), {0, 1, nan, 0, 0, 1});
    const MeshTopology topology(mesh);
    EXPECT_EQ(topology.triangleCount(), 12u);
    EXPECT_TRUE(topology.closed());
}

TEST(Silhouette, MirrorSwapsTheSidesAndTheWayOfTheCaps) {
    const VolumeTriangles plain = volumeOf(cube(), {.light_local = kSunAbove});
    const VolumeTriangles mirrored = volumeOf(cube(), {.light_local = kSunAbove, .mirrored = true});
    // The caps that were clockwise from outside are counter-clockwise in the mirror.
    EXPECT_TRUE(mirrored.inwardLightCaps.empty());
    EXPECT_EQ(mirrored.lightCaps, plain.inwardLightCaps);
    EXPECT_EQ(mirrored.sides[0], plain.sides[1]);
    EXPECT_EQ(mirrored.sides[1], plain.sides[0]);
}

TEST(Silhouette, PairsHoldEveryUseOfEveryEdgeOnce) {
    // Three sheets at one edge, which is used three times, and six edges used once.
    Mesh fan;
    fan.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}};
    fan.indices = {0, 1, 2, 0, 1, 3, 1, 0, 4};
    const std::vector<EdgePair> pairs = MeshTopology(fan).edgePairs();
    ASSERT_EQ(pairs.size(), 8u);
    std::vector<std::uint32_t> shared;
    for (const EdgePair& pair : pairs)
        if (pair.vertices == glm::uvec2(0, 1)) shared.insert(shared.end(), {pair.uses.x, pair.uses.y});
    EXPECT_EQ(shared, (std::vector<std::uint32_t>{0, 5, 2, EdgePair::kNoUse}));
}

TEST(Silhouette, VolumesAroundAPointAreTheCastersBetweenItAndTheLight) {
    const Mesh mesh = cube();
    const MeshTopology topology(mesh);
    const auto around = [&](const glm::dvec3& p, VolumeRequest request) {
        return volumesAround(topology, mesh, request, p);
    };
    const VolumeRequest lamp{.light_local = kLampAbove};
    EXPECT_EQ(around({0.1, -3, 0.2}, lamp), 1);  // below
    EXPECT_EQ(around({4, -3, 0.2}, lamp), 0);    // beside
    EXPECT_EQ(around({0.1, 1, 0.2}, lamp), 0);   // above
    VolumeRequest both = lamp;
    both.both = true;
    EXPECT_EQ(around({0.1, -3, 0.2}, both), 2);  // the way crosses the bottom and the top
    EXPECT_EQ(around({0.1, 0, 0.2}, both), 1);   // from the inside the top alone
    // Straight through the diagonals of both faces, which two triangles share: still each face once.
    const glm::dvec4 sun(0, 1, 0, 0);
    EXPECT_EQ(around({0, -3, 0}, {.light_local = sun, .both = true}), 2);
    EXPECT_EQ(around({0.25, -3, 0.25}, {.light_local = sun, .both = true}), 2);
}

TEST(Silhouette, ATriangleWhosePlaneHoldsTheLightCastsNothing) {
    const auto caps = [](const glm::dvec4& light_local, double inPlane) {
        const VolumeTriangles v =
            volumeOf(cube(), {.light_local = light_local, .inPlane_local = inPlane, .both = true});
        return (v.lightCaps.size() + v.inwardLightCaps.size()) / 3;
    };
    EXPECT_EQ(caps({3, 0.5, 0, 1}, 0), 10u);         // in the plane of the top
    EXPECT_EQ(caps({3, 0.5 + 1e-9, 0, 1}, 0), 12u);  // a little above
    EXPECT_EQ(caps({3, 0.5 + 1e-9, 0, 1}, 1e-6), 10u);
    EXPECT_EQ(caps({3, 0.5 - 1e-9, 0, 1}, 1e-6), 10u);
    EXPECT_EQ(caps({3, 0.5 + 1e-5, 0, 1}, 1e-6), 12u);
}

TEST(Silhouette, VolumesThatEndBeforeAPointDoNotHoldIt) {
    const Mesh mesh = cube();
    const MeshTopology topology(mesh);
    const VolumeRequest sun{.light_local = {0, 1, 0, 0}, .both = true};
    const glm::dvec3 p(0.1, -3, 0.2);  // 2.5 m under the bottom, 3.5 under the top
    const auto around = [&](double distance_m) {
        return volumesAround(topology, mesh, sun, p, VolumeEnd{distance_m, sun.light_local, glm::dmat4(1.0)});
    };
    EXPECT_EQ(around(2.4), 0);
    EXPECT_EQ(around(3), 1);
    EXPECT_EQ(around(4), 2);
}

TEST(Silhouette, TellsWhetherTheWayToTheLightTouchesAnEdge) {
    const Mesh mesh = cube();
    const MeshTopology topology(mesh);
    const auto touches = [&](const glm::dvec3& p) { return touchesEdge(topology, mesh, {3, 3, 0, 1}, p); };
    EXPECT_TRUE(touches({-2, -2, 0}));         // through the edge from (0.5, 0.5, -0.5) to (0.5, 0.5, 0.5)
    EXPECT_FALSE(touches({-2, -2.001, 0.1}));  // beside it
    EXPECT_FALSE(touches({1, 1, 0}));          // the edge lies behind the point
    EXPECT_FALSE(touchesEdge(topology, mesh, {0.2, 0.2, 0, 1}, {-0.2, -0.2, 0.01}));  // and behind the light
    EXPECT_TRUE(touchesEdge(topology, mesh, {1, 1, 0, 0}, {-2, -2, 0}));              // a sun
}

}  // namespace
}  // namespace ombrage
