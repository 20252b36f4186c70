// SPDX-License-Identifier: MIT
#include "reference/bvh_builder.h"

#include <algorithm>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace ombrage {
namespace {

/// Small triangles anywhere in a cube of 10 m.
void scatter(std::size_t count, std::vector<glm::vec3>& positions, std::vector<glm::uvec3>& triangles) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> anywhere(-5.0f, 5.0f), near(-0.2f, 0.2f);
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec3 centre(anywhere(random), anywhere(random), anywhere(random));
        for (int k = 0; k < 3; ++k) positions.push_back(centre + glm::vec3(near(random), near(random), near(random)));
        const auto first = std::uint32_t(positions.size()) - 3;
        triangles.emplace_back(first, first + 1, first + 2);
    }
}

std::vector<std::uint32_t> everyId(std::size_t count) {
    std::vector<std::uint32_t> ids(count);
    for (std::size_t i = 0; i < count; ++i) ids[i] = std::uint32_t(i);
    return ids;
}

bool inside(const BvhNode& inner, const BvhNode& outer) {
    return glm::all(glm::greaterThanEqual(inner.lower, outer.lower)) && glm::all(glm::lessThanEqual(inner.upper, outer.upper));
}

TEST(BvhBuilder, HoldsEveryWantedTriangleOnceInsideItsLeaf) {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;
    scatter(5000, positions, triangles);
    std::vector<std::uint32_t> wanted = everyId(triangles.size());
    wanted.erase(wanted.begin() + 100, wanted.begin() + 200);
    const Bvh bvh = buildBvh(positions, triangles, wanted);

    std::vector<std::uint32_t> held = bvh.order;
    std::sort(held.begin(), held.end());
    EXPECT_EQ(held, wanted);
    for (const BvhNode& node : bvh.nodes)
        for (std::uint32_t i = 0; i < node.triangleCount(); ++i) {
            const glm::uvec3 t = triangles[bvh.order[node.firstTriangle() + i]];
            for (int k = 0; k < 3; ++k) {
                const glm::vec3 p = positions[t[k]];
                EXPECT_TRUE(glm::all(glm::greaterThanEqual(p, node.lower)) && glm::all(glm::lessThanEqual(p, node.upper)));
            }
        }
}

TEST(BvhBuilder, SkippingLeavesTheSubtreeAndBoxesNest) {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;
    scatter(2000, positions, triangles);
    const Bvh bvh = buildBvh(positions, triangles, everyId(triangles.size()));
    ASSERT_FALSE(bvh.nodes.empty());
    EXPECT_EQ(bvh.nodes[0].skip, bvh.nodes.size());
    for (std::uint32_t i = 0; i < bvh.nodes.size(); ++i) {
        const BvhNode& node = bvh.nodes[i];
        ASSERT_GT(node.skip, i);
        ASSERT_LE(node.skip, bvh.nodes.size());
        // A leaf is one node; an inner node is followed by its two children, and the second ends where it ends.
        if (node.triangleCount() > 0) {
            EXPECT_EQ(node.skip, i + 1);
            continue;
        }
        const std::uint32_t second = bvh.nodes[i + 1].skip;
        ASSERT_LT(second, node.skip);
        EXPECT_EQ(bvh.nodes[second].skip, node.skip);
        EXPECT_TRUE(inside(bvh.nodes[i + 1], node));
        EXPECT_TRUE(inside(bvh.nodes[second], node));
    }
}

TEST(BvhBuilder, ManyEqualBoxesStillEndInLeavesOfFewTriangles) {
    // 300 copies of one triangle cannot be told apart by any split plane.
    std::vector<glm::vec3> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const std::vector<glm::uvec3> triangles(300, glm::uvec3(0, 1, 2));
    const Bvh bvh = buildBvh(positions, triangles, everyId(300));
    EXPECT_EQ(bvh.order.size(), 300u);
    for (const BvhNode& node : bvh.nodes) EXPECT_LE(node.triangleCount(), 15u);
    EXPECT_LE(bvh.depth, 64);
}

TEST(BvhBuilder, NothingToHoldGivesNoNodes) {
    EXPECT_TRUE(buildBvh({}, {}, {}).nodes.empty());
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<glm::vec3> positions{{0, 0, 0}, {nan, 0, 0}, {0, 1, 0}};
    EXPECT_TRUE(buildBvh(positions, {{0, 1, 2}}, {0}).nodes.empty());
}

}  // namespace
}  // namespace ombrage
