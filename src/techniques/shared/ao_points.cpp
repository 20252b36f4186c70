// SPDX-License-Identifier: MIT
#include "techniques/shared/ao_points.h"

#include <algorithm>
#include <cmath>

namespace ombrage {

constexpr double kTwoPi = 6.28318530717958647693;

glm::dvec3 ballPoint(double u, double v, double w) {
    const double z = 1 - 2 * u, across = std::sqrt(std::max(0.0, 1 - z * z)), length = std::cbrt(w);
    return glm::dvec3(across * std::cos(kTwoPi * v), across * std::sin(kTwoPi * v), z) * length;
}

glm::dvec3 cosineDirection(const glm::dvec3& normal, double u, double v) {
    // Any frame about the normal will do: the azimuth is even.
    const glm::dvec3 aside = std::abs(normal.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 t = glm::normalize(glm::cross(normal, aside)), b = glm::cross(normal, t);
    const double across = std::sqrt(u);
    return t * (across * std::cos(kTwoPi * v)) + b * (across * std::sin(kTwoPi * v)) + normal * std::sqrt(1 - u);
}

double depthBetween(const AoReceiver& receiver, const glm::dvec3& surface, const glm::dvec3& point) {
    const glm::dvec3 back = glm::cross(receiver.right, receiver.up);
    return glm::dot(surface - point, back);
}

}  // namespace ombrage
