// SPDX-License-Identifier: MIT
#include "scene/polygon.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace ombrage {
namespace {

/// Sum and sum of amounts of the triangles' areas along +z.
std::pair<double, double> areas(const std::vector<glm::vec3>& corners, const std::vector<std::uint32_t>& triangles) {
    double sum = 0, amounts = 0;
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
        const glm::vec3 a = corners[triangles[i]], b = corners[triangles[i + 1]], c = corners[triangles[i + 2]];
        const double area = 0.5 * double(glm::cross(b - a, c - a).z);
        sum += area;
        amounts += std::abs(area);
    }
    return {sum, amounts};
}

TEST(Polygon, ConcaveOnesAreCoveredOnce) {
    // An L, an arrow head and a comb; areas by hand.
    const std::vector<glm::vec3> ell{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
    const std::vector<glm::vec3> arrow{{0, 0, 0}, {2, -1, 0}, {0, 2, 0}, {-2, -1, 0}};
    const std::vector<glm::vec3> comb{{0, 0, 0}, {5, 0, 0}, {5, 3, 0}, {4, 3, 0}, {4, 1, 0}, {3, 1, 0},
                                      {3, 3, 0}, {2, 3, 0}, {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
    const std::vector<std::pair<std::vector<glm::vec3>, double>> known{{ell, 3.0}, {arrow, 4.0}, {comb, 11.0}};
    for (auto [corners, area] : known) {
        for (std::size_t turned = 0; turned < corners.size(); ++turned) {
            std::vector<std::uint32_t> triangles;
            triangulate(corners, triangles);
            EXPECT_EQ(triangles.size(), 3 * (corners.size() - 2));
            const auto [sum, amounts] = areas(corners, triangles);
            // Whole numbers: the sums are exact. Equal amounts mean that no triangle lies outside or upside down.
            EXPECT_EQ(sum, area);
            EXPECT_EQ(amounts, area);
            std::rotate(corners.begin(), corners.begin() + 1, corners.end());
        }
        // Clockwise polygons stay clockwise.
        std::reverse(corners.begin(), corners.end());
        std::vector<std::uint32_t> triangles;
        triangulate(corners, triangles);
        EXPECT_EQ(areas(corners, triangles).first, -area);
    }
}

TEST(Polygon, OddOnesGiveTheirTrianglesAndEnd) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::vector<glm::vec3> star, broken, circle;
    for (int i = 0; i < 5; ++i) star.emplace_back(std::cos(2.513 * i), std::sin(2.513 * i), 0.0);
    for (int i = 0; i < 7; ++i) broken.emplace_back(i % 3 == 0 ? nan : float(i), float(i * i % 5), 0.0f);
    for (int i = 0; i < 20000; ++i) circle.emplace_back(std::cos(i * 3.14159e-4), std::sin(i * 3.14159e-4), i % 2);
    for (const auto& corners : {star, broken, circle}) {
        std::vector<std::uint32_t> triangles;
        triangulate(corners, triangles);
        EXPECT_EQ(triangles.size(), 3 * (corners.size() - 2));
    }
    std::vector<std::uint32_t> none;
    triangulate(std::vector<glm::vec3>(2), none);
    EXPECT_TRUE(none.empty());
}

}  // namespace
}  // namespace ombrage
