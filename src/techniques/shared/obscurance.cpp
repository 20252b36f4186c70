// SPDX-License-Identifier: MIT
#include "techniques/shared/obscurance.h"

#include <algorithm>

namespace ombrage {

double obscuranceFrom(const AoReceiver& receiver, const glm::dvec3& v, double bias_m, double epsilon_m) {
    const double rise_m = std::min(glm::dot(v, receiver.shadingNormal), glm::dot(v, receiver.normal));
    return std::max(0.0, rise_m - bias_m) / (glm::dot(v, v) + epsilon_m * epsilon_m);
}

}  // namespace ombrage
