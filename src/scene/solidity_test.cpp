// SPDX-License-Identifier: MIT
#include "scene/solidity.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "scene/shapes.h"

namespace ombrage {
namespace {

Mesh joined(Mesh a, const Mesh& b) {
    const auto base = std::uint32_t(a.positions.size());
    a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
    for (std::uint32_t index : b.indices) a.indices.push_back(base + index);
    return a;
}

Mesh turned(Mesh mesh) {
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) std::swap(mesh.indices[i], mesh.indices[i + 1]);
    return mesh;
}

Mesh moved(Mesh mesh, const glm::vec3& by) {
    for (glm::vec3& p : mesh.positions) p += by;
    return mesh;
}

const Mesh kBox = shapes::box(glm::vec3(-1), glm::vec3(1));
const Mesh kSmallBox = shapes::box(glm::vec3(-0.5f), glm::vec3(0.5f));

TEST(Solidity, ClosedOutwardMeshesAreSolid) {
    EXPECT_TRUE(isSolid(kBox));
    EXPECT_TRUE(isSolid(joined(kBox, moved(kBox, {5, 0, 0}))));
    EXPECT_TRUE(isSolid(joined(kBox, moved(kBox, {0.5f, 0.25f, 0})))) << "parts may overlap";
}

TEST(Solidity, AHoleOrATurnedTriangleIsNoticed) {
    for (std::size_t t = 0; t < kBox.triangleCount(); ++t) {
        Mesh hole = kBox, twisted = kBox;
        hole.indices.erase(hole.indices.begin() + std::ptrdiff_t(3 * t),
                           hole.indices.begin() + std::ptrdiff_t(3 * t + 3));
        std::swap(twisted.indices[3 * t], twisted.indices[3 * t + 1]);
        EXPECT_FALSE(isSolid(hole)) << t;
        EXPECT_FALSE(isSolid(twisted)) << t;
    }
}

TEST(Solidity, PartsThatLookInwardAreNotSolid) {
    EXPECT_FALSE(isSolid(turned(kBox)));
    EXPECT_FALSE(isSolid(joined(kBox, turned(moved(kSmallBox, {5, 0, 0})))))
        << "the bigger part must not make up for it";
    EXPECT_FALSE(isSolid(joined(kBox, turned(kSmallBox)))) << "a cavity";
}

TEST(Solidity, NothingAndSheetsAreNotSolid) {
    EXPECT_FALSE(isSolid(Mesh{}));
    Mesh sheet;
    sheet.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    sheet.indices = {0, 1, 2, 0, 2, 1};
    EXPECT_FALSE(isSolid(sheet));
}

}  // namespace
}  // namespace ombrage
