// SPDX-License-Identifier: MIT
#include "techniques/shared/disks.h"

#include <cmath>
#include <limits>
#include <random>

#include <glm/gtc/constants.hpp>

#include "core/blue_noise.h"

namespace ombrage {

std::vector<glm::vec2> vogelDisk(int count) {
    const float goldenAngle_rad = glm::pi<float>() * (3.0f - std::sqrt(5.0f));
    std::vector<glm::vec2> points;
    for (int k = 0; k < count; ++k) {
        const float radius = std::sqrt((float(k) + 0.5f) / float(count)), angle_rad = float(k) * goldenAngle_rad;
        points.push_back(radius * glm::vec2(std::cos(angle_rad), std::sin(angle_rad)));
    }
    return points;
}

std::vector<glm::vec2> poissonDisk(int count) {
    std::mt19937 random(1);
    const auto unit = [&random] { return float(random() >> 8) * (1.0f / 8388608.0f) - 1.0f; };
    std::vector<glm::vec2> points;
    while (points.size() < std::size_t(count)) {
        // More candidates for later points keep the density even.
        glm::vec2 best(0.0f);
        float bestApart = -1.0f;
        for (std::size_t c = 0; c < 32 * (points.size() + 1); ++c) {
            const glm::vec2 candidate(unit(), unit());
            if (glm::dot(candidate, candidate) > 1.0f) continue;
            float apart = std::numeric_limits<float>::infinity();
            for (const glm::vec2& p : points) apart = std::min(apart, glm::dot(p - candidate, p - candidate));
            if (apart > bestApart) {
                bestApart = apart;
                best = candidate;
            }
        }
        points.push_back(best);
    }
    return points;
}

gl::Texture blueNoiseTexture() {
    constexpr int kSize_px = 64;
    gl::Texture texture({.format = GL_R32F, .width = kSize_px, .height = kSize_px}, "blue noise");
    std::vector<float> turns;
    for (const std::uint32_t rank : blueNoise(kSize_px, 1)) turns.push_back(float(rank) / float(kSize_px * kSize_px));
    texture.upload(0, GL_RED, GL_FLOAT, turns.data());
    return texture;
}

}  // namespace ombrage
