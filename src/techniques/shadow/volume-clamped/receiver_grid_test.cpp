// SPDX-License-Identifier: MIT
#include "techniques/shadow/volume-clamped/receiver_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace ombrage {
namespace {

constexpr int kCells = 8;

/// The cell that receiver_grid.comp notes a point in.
std::size_t cellOf(const LightRays& rays, const glm::vec3& p) {
    const auto index = [](float at) { return std::clamp(int(at * float(kCells)), 0, kCells - 1); };
    if (rays.sun) {
        const glm::vec2 at = (glm::vec2(glm::dot(p, rays.right), glm::dot(p, rays.up)) - rays.corner) / rays.size;
        return std::size_t(index(at.y) * kCells + index(at.x));
    }
    const glm::vec3 d = p - rays.position, a = glm::abs(d);
    const int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    const int face = axis * 2 + (d[axis] >= 0 ? 0 : 1);
    const float u = d[(axis + 1) % 3] / a[axis] * 0.5f + 0.5f, v = d[(axis + 2) % 3] / a[axis] * 0.5f + 0.5f;
    return std::size_t((face * kCells + index(v)) * kCells + index(u));
}

ReceiverGrid gridOf(const LightRays& rays, const std::vector<glm::vec3>& receivers) {
    std::vector<glm::uvec2> cells(std::size_t(rays.faces() * kCells * kCells), glm::uvec2(ReceiverGrid::kEmpty, 0u));
    for (const glm::vec3& p : receivers) {
        const float distance_m = rays.sun ? rays.along(rays.direction, p) : glm::distance(p, rays.position);
        glm::uvec2& cell = cells[cellOf(rays, p)];
        cell.x = std::min(cell.x, std::bit_cast<std::uint32_t>(distance_m));
        cell.y = std::max(cell.y, std::bit_cast<std::uint32_t>(distance_m));
    }
    return {rays, kCells, std::move(cells)};
}

LightRays slantedSun() {
    const glm::vec3 direction = glm::normalize(glm::vec3(-1, -2, -0.7f));
    return LightRays::ofSun(direction, glm::normalize(glm::cross(direction, glm::vec3(0, 0, 1))), glm::vec3(-5),
                            glm::vec3(5));
}

TEST(LightRays, PlanesLieAcrossTheAxisAtTheDistance) {
    for (const LightRays& rays : {slantedSun(), LightRays::from({1, 3, -2})}) {
        const auto box = rays.sight({-1, -1, -1}, {1, 0, 1});
        ASSERT_TRUE(box);
        EXPECT_GT(box->farthest_m, box->nearest_m);
        // A corner of the box lies between planes at its two distances, the light before both.
        for (const glm::vec3& p : {glm::vec3(-1, -1, -1), glm::vec3(1, 0, 1), glm::vec3(1, -1, -1)}) {
            // Rounding of coordinates of some metres: 1e-6.
            EXPECT_GE(glm::dot(rays.plane(box->axis, box->nearest_m), glm::vec4(p, 1)), -1e-5f);
            EXPECT_LE(glm::dot(rays.plane(box->axis, box->farthest_m), glm::vec4(p, 1)), 1e-5f);
        }
        const glm::vec4 toward = rays.sun ? glm::vec4(-rays.direction, 0) : glm::vec4(rays.position, 1);
        EXPECT_LT(glm::dot(rays.plane(box->axis, box->nearest_m), toward), 0.0f);
    }
}

TEST(LightRays, SeeNoBoxThatTheyStartIn) {
    EXPECT_FALSE(LightRays::from({0, 0, 0}).sight({-1, -1, -1}, {1, 1, 2}));
    // Beside a wide box no axis has all of it before the light.
    EXPECT_FALSE(LightRays::from({0, 0.01f, 0}).sight({-5, -1, -5}, {5, 0, 5}));
    EXPECT_TRUE(slantedSun().sight({-1, -1, -1}, {1, 1, 2}));
}

TEST(ReceiverGrid, KnowsASingleReceiver) {
    // 4 m under a lamp, in the shadow of a box half way.
    const LightRays lamp = LightRays::from({0, 4, 0});
    const ReceiverGrid grid = gridOf(lamp, {{0.01f, 0, 0.02f}});
    const auto box = lamp.sight({-0.5f, 1.9f, -0.5f}, {0.5f, 2.1f, 0.5f});
    ASSERT_TRUE(box);
    const auto found = grid.receiversOf(*box);
    ASSERT_TRUE(found);
    // The bounds are those of a cell: its half diagonal is some 10 degrees.
    EXPECT_GE(found->farthest_m, 4.0f);
    EXPECT_LE(found->nearest_m, 4.0f);
    EXPECT_GT(found->nearest_m, 4.0f * std::cos(0.4f));
    EXPECT_NEAR(grid.farthestOf(*box), 4.0f, 1e-3f);
    // Nothing lies behind a box to the lamp's side.
    const auto aside = lamp.sight({3, 3.5f, -0.5f}, {3.5f, 4.5f, 0.5f});
    ASSERT_TRUE(aside);
    EXPECT_FALSE(grid.receiversOf(*aside));
    EXPECT_LT(grid.farthestOf(*aside), 0.0f);
}

/// Whatever a box shades, its range holds: receivers on rays through random points of random boxes.
TEST(ReceiverGrid, HoldsEveryReceiverInABoxsShadow) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> coordinate(-4, 4), extent(0.05f, 1.5f), share(0, 1);
    for (const LightRays& rays : {slantedSun(), LightRays::from({0.3f, 4.5f, -0.2f})}) {
        int seen = 0;
        for (int trial = 0; trial < 500; ++trial) {
            const glm::vec3 lower(coordinate(random), coordinate(random), coordinate(random));
            const glm::vec3 upper = lower + glm::vec3(extent(random), extent(random), extent(random));
            const auto box = rays.sight(lower, upper);
            if (!box) continue;
            ++seen;
            const glm::vec3 inside = glm::mix(lower, upper, glm::vec3(share(random), share(random), share(random)));
            const glm::vec3 away = rays.sun ? rays.direction : glm::normalize(inside - rays.position);
            const glm::vec3 receiver = inside + away * (3 * share(random));
            // A sun's grid covers the bounds alone, in which all receivers lie.
            if (rays.sun && glm::any(glm::greaterThan(glm::abs(receiver), glm::vec3(5)))) continue;
            const auto found = gridOf(rays, {receiver}).receiversOf(*box);
            ASSERT_TRUE(found);
            const float along_m = rays.along(box->axis, receiver);
            EXPECT_LE(found->nearest_m, along_m + 1e-4f);
            EXPECT_GE(found->farthest_m, along_m - 1e-4f);
        }
        EXPECT_GT(seen, 300);
    }
}

}  // namespace
}  // namespace ombrage
