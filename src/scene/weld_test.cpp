// SPDX-License-Identifier: MIT
#include "scene/weld.h"

#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <tuple>

#include <gtest/gtest.h>

namespace ombrage {
namespace {

using Numbers = std::vector<std::uint32_t>;

TEST(Weld, GivesTheFirstVertexAtThePosition) {
    EXPECT_EQ(weldedVertices({}), Numbers());
    EXPECT_EQ(weldedVertices({{1, 2, 3}}), Numbers({0}));
    EXPECT_EQ(weldedVertices({{1, 2, 3}, {3, 2, 1}, {1, 2, 3}, {2, 1, 3}, {3, 2, 1}, {1, 2, 3}}),
              Numbers({0, 1, 0, 3, 1, 0}));
}

TEST(Weld, NearIsNotEqual) {
    const float next = std::nextafter(1.0f, 2.0f), least = std::numeric_limits<float>::denorm_min();
    EXPECT_EQ(weldedVertices({{1, 1, 1}, {next, 1, 1}, {1, next, 1}, {1, 1, next}, {0, 0, 0}, {least, 0, 0}}),
              Numbers({0, 1, 2, 3, 4, 5}));
}

TEST(Weld, BothZerosAreOne) {
    EXPECT_EQ(weldedVertices({{0, 1, 2}, {-0.0f, 1, 2}, {1, -0.0f, 0}, {1, 0, -0.0f}}), Numbers({0, 0, 2, 2}));
}

TEST(Weld, WhatIsNoNumberEqualsNone) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(weldedVertices({{nan, 0, 0}, {nan, 0, 0}, {0, 0, nan}, {infinity, 0, 0}, {infinity, 0, 0}}),
              Numbers({0, 1, 2, 3, 3}));
    // So many that comparing each with each would take minutes.
    const Numbers alone = weldedVertices(std::vector<glm::vec3>(1000000, glm::vec3(nan)));
    for (std::size_t i = 0; i < alone.size(); ++i) ASSERT_EQ(alone[i], i);
}

TEST(Weld, AgreesWithASortedMap) {
    // Few places, met some eight times each, along the axes of a grid, where bad hashes collide.
    std::mt19937 random(1);
    std::uniform_int_distribution<int> step(-10, 9);
    std::vector<glm::vec3> positions(64000);
    for (glm::vec3& p : positions) p = glm::vec3(step(random), step(random), step(random)) * 0.25f;
    std::map<std::tuple<float, float, float>, std::uint32_t> seen;
    const Numbers welded = weldedVertices(positions);
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const glm::vec3& p = positions[i];
        ASSERT_EQ(welded[i], seen.try_emplace({p.x, p.y, p.z}, std::uint32_t(i)).first->second) << i;
    }
}

}  // namespace
}  // namespace ombrage
