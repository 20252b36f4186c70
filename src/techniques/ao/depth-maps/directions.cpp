// SPDX-License-Identifier: MIT
#include "techniques/ao/depth-maps/directions.h"

#include <cmath>

namespace ombrage::depth_maps {

std::vector<glm::vec3> evenDirections(int count) {
    constexpr double kGoldenAngle_rad = 2.39996322972865332;
    std::vector<glm::vec3> directions;
    for (int i = 0; i < count; ++i) {
        const double height = 1 - (2.0 * i + 1) / count, across = std::sqrt(1 - height * height);
        const double azimuth_rad = i * kGoldenAngle_rad;
        directions.emplace_back(across * std::cos(azimuth_rad), height, across * std::sin(azimuth_rad));
    }
    return directions;
}

}  // namespace ombrage::depth_maps
