// SPDX-License-Identifier: MIT
#include "scene/weld.h"

#include <bit>
#include <cstddef>

#include "core/hash.h"

namespace ombrage {

namespace {

/// 0 for both zeros.
std::uint64_t bitsOf(float value) {
    return value == 0.0f ? 0u : std::bit_cast<std::uint32_t>(value);
}

std::uint64_t hashOf(const glm::vec3& p) {
    return mixedBits((bitsOf(p.x) << 32 | bitsOf(p.y)) + mixedBits(bitsOf(p.z) + 1));
}

}  // namespace

std::vector<std::uint32_t> weldedVertices(const std::vector<glm::vec3>& positions) {
    // A hash table with open addressing, at most half full. It holds vertices alone; their positions are at hand. (On
    // 100,000 to 600,000 vertices 3 to 10 times as fast as sorting them, and 1.2 to 9 times as fast as the standard
    // library's hash map.)
    constexpr std::uint32_t kFree = 0xffffffffu;
    const std::size_t mask = std::bit_ceil(2 * positions.size() + 1) - 1;
    std::vector<std::uint32_t> table(mask + 1, kFree);
    std::vector<std::uint32_t> first(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const glm::vec3& p = positions[i];
        first[i] = std::uint32_t(i);
        if (p != p) continue;  // in the table, many of them would be found one after the other
        std::size_t slot = hashOf(p) & mask;
        while (table[slot] != kFree && positions[table[slot]] != p) slot = (slot + 1) & mask;
        if (table[slot] == kFree) table[slot] = std::uint32_t(i);
        first[i] = table[slot];
    }
    return first;
}

}  // namespace ombrage
