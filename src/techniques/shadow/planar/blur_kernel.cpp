// SPDX-License-Identifier: MIT
#include "techniques/shadow/planar/blur_kernel.h"

#include <cmath>

namespace ombrage::planar {

std::vector<glm::vec4> blurKernel(int samples) {
    constexpr float kGoldenAngle_rad = 2.39996323f;
    std::vector<glm::vec4> kernel;
    for (int i = 0; i < samples; ++i) {
        const float angle_rad = kGoldenAngle_rad * float(i), share = float(i) / float(samples);
        const glm::vec2 direction(std::cos(angle_rad), std::sin(angle_rad));
        kernel.emplace_back(direction * std::sqrt((float(i) + 0.5f) / float(samples)), direction * (share * share));
    }
    return kernel;
}

}  // namespace ombrage::planar
