// SPDX-License-Identifier: MIT
#include "render/faceted_mesh.h"

#include <set>

#include <gtest/gtest.h>

namespace ombrage {
namespace {

const Mesh& meshOf(const Scene& scene) {
    return scene.meshes.front();
}

TEST(FacetedMesh, EveryTriangleOwnsItsLastCorner) {
    const Scene scene = loadScene("sphere");
    for (const Mesh& mesh : scene.meshes) {
        const FacetedMesh made = facet(mesh);
        ASSERT_EQ(made.indices.size(), mesh.indices.size());
        std::set<std::uint32_t> owned;
        for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
            const std::uint32_t last = made.indices[3 * t + 2];
            EXPECT_EQ(made.triangle[last], t);
            EXPECT_TRUE(owned.insert(last).second) << "two triangles end in vertex " << last;
        }
    }
}

TEST(FacetedMesh, CornersStayWhatAndWhereTheyWere) {
    const Scene scene = loadScene("sphere");
    for (const Mesh& mesh : scene.meshes) {
        const FacetedMesh made = facet(mesh);
        for (std::size_t corner = 0; corner < mesh.indices.size(); ++corner)
            ASSERT_EQ(made.source[made.indices[corner]], mesh.indices[corner]) << "corner " << corner;
    }
}

// A strip's every vertex ends some triangle or none: 4 corners, 2 triangles, and a fan whose 6 triangles share a corner.
TEST(FacetedMesh, MakesNoMoreVerticesThanNeeded) {
    Mesh quad = meshOf(loadScene("sphere"));
    quad.positions.resize(4);
    quad.indices = {0, 1, 2, 0, 2, 3};
    EXPECT_EQ(facet(quad).source.size(), 4u);

    // All six end in vertex 0: six copies of it, and the six others.
    Mesh fan = quad;
    fan.positions.resize(7);
    fan.indices.clear();
    for (std::uint32_t i = 0; i < 6; ++i) fan.indices.insert(fan.indices.end(), {1 + i, 1 + (i + 1) % 6, 0});
    EXPECT_EQ(facet(fan).source.size(), 12u);
}

TEST(FacetedMesh, AnEmptyMeshStaysEmpty) {
    EXPECT_TRUE(facet(Mesh{}).indices.empty());
}

}  // namespace
}  // namespace ombrage
