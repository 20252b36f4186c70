// SPDX-License-Identifier: MIT
#include "scene/patterns.h"

#include <algorithm>
#include <cmath>

namespace ombrage::patterns {

namespace {
Texture blank(const char* name, int size, bool srgb) {
    Texture texture;
    texture.name = name;
    texture.width = texture.height = size;
    texture.srgb = srgb;
    texture.rgba.assign(std::size_t(size) * std::size_t(size) * 4, 255);
    return texture;
}

std::uint8_t* texel(Texture& texture, int x, int y) {
    return &texture.rgba[4 * (std::size_t(y) * std::size_t(texture.width) + std::size_t(x))];
}

std::uint8_t byteOf(float share) {
    return std::uint8_t(std::lround(std::clamp(share, 0.0f, 1.0f) * 255.0f));
}

/// 0 at the rim of a brick or tile, 1 where it is flat, over `rim_px`.
float dome(int x, int y, int width, int height, int joint, float rim) {
    const int inward = std::min(std::min(x, width - 1 - x), std::min(y, height - 1 - y)) - joint;
    return inward < 0 ? 0.0f : std::sqrt(std::min(1.0f, (float(inward) + 0.5f) / rim));
}
}  // namespace

float noise(std::uint32_t a, std::uint32_t b) {
    // Two rounds of a multiply-and-shift mixer; only its evenness matters.
    std::uint32_t h = a * 0x9e3779b1u ^ (b + 0x7f4a7c15u) * 0x85ebca77u;
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12)) * 0x297a2d39u;
    return float((h ^ (h >> 15)) >> 8) / 16777216.0f;
}

Texture lattice(float slat) {
    constexpr int kSize = 64;
    Texture texture = blank("lattice", kSize, true);
    const int width = int(slat * kSize);
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            const bool upright = x < width, level = y < width;
            std::uint8_t* to = texel(texture, x, y);
            const int shade = upright ? 236 : 205;
            to[0] = std::uint8_t(shade);
            to[1] = std::uint8_t(shade - 10);
            to[2] = std::uint8_t(shade - 28);
            to[3] = upright || level ? 255 : 0;
        }
    return texture;
}

Texture leaf() {
    constexpr int kSize = 64;
    Texture texture = blank("leaf", kSize, true);
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            // A pointed oval from the stalk below to the tip above, brighter along its veins.
            const float u = (float(x) + 0.5f) / kSize * 2.0f - 1.0f, t = 1.0f - (float(y) + 0.5f) / kSize;
            const float half = 1.45f * t * (1.0f - t) * (1.6f - t);
            const bool vein = std::abs(u) < 0.03f || std::fmod(std::abs(u) * 0.7f + 1.0f - t, 0.16f) < 0.02f;
            std::uint8_t* to = texel(texture, x, y);
            to[0] = vein ? 150 : 96;
            to[1] = vein ? 178 : 142;
            to[2] = vein ? 96 : 58;
            to[3] = std::abs(u) < half ? 255 : 0;
        }
    return texture;
}

Texture brickHeights() {
    constexpr int kSize = 256, kWidth = 128, kHeight = 64;
    Texture texture = blank("brick heights", kSize, false);
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            const int course = y / kHeight, shifted = (x + (course % 2) * kWidth / 2) % kSize;
            const int brick = course * 2 + shifted / kWidth;
            const float rim = dome(shifted % kWidth, y % kHeight, kWidth, kHeight, 4, 8.0f);
            const float rough = 0.05f * noise(std::uint32_t(x / 2), std::uint32_t(y / 2));
            const float face = 0.82f + 0.13f * noise(std::uint32_t(brick), 77u) - rough;
            const std::uint8_t height = byteOf(rim * face);
            std::uint8_t* to = texel(texture, x, y);
            to[0] = to[1] = to[2] = height;
        }
    return texture;
}

Texture tileHeights() {
    constexpr int kSize = 256, kTile = 128;
    Texture texture = blank("tile heights", kSize, false);
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            const float rim = dome(x % kTile, y % kTile, kTile, kTile, 3, 14.0f);
            const float rough = 0.03f * noise(std::uint32_t(x / 4), std::uint32_t(y / 4) + 1000u);
            std::uint8_t* to = texel(texture, x, y);
            to[0] = to[1] = to[2] = byteOf(rim * (0.95f - rough));
        }
    return texture;
}

Texture normalsOf(const Texture& heights, float scale_uv) {
    Texture normals = blank("normals", heights.width, false);
    normals.name = heights.name + " as normals";
    const auto at = [&](int x, int y) {
        const int wrappedX = (x + heights.width) % heights.width, wrappedY = (y + heights.height) % heights.height;
        return float(heights.rgba[4 * (std::size_t(wrappedY) * std::size_t(heights.width) + std::size_t(wrappedX))]) /
               255.0f;
    };
    for (int y = 0; y < heights.height; ++y)
        for (int x = 0; x < heights.width; ++x) {
            // Central differences; rows run to growing v, the map's second axis to falling v.
            const float slopeU = (at(x + 1, y) - at(x - 1, y)) * 0.5f * float(heights.width) * scale_uv;
            const float slopeV = (at(x, y + 1) - at(x, y - 1)) * 0.5f * float(heights.height) * scale_uv;
            const glm::vec3 n = glm::normalize(glm::vec3(-slopeU, slopeV, 1.0f));
            std::uint8_t* to = texel(normals, x, y);
            for (int i = 0; i < 3; ++i) to[i] = byteOf(n[i] * 0.5f + 0.5f);
        }
    return normals;
}

}  // namespace ombrage::patterns
