// SPDX-License-Identifier: MIT
#include "core/hash.h"

#include <cstring>

#include <fmt/format.h>

namespace ombrage {

namespace {
constexpr std::uint64_t kPrime = 0x100000001b3ull;
}

void Hasher::bytes(const void* data, std::size_t size) {
    const auto* cursor = static_cast<const unsigned char*>(data);
    m_length += size;
    // Whole words first; the xor-shift spreads the high bits that the odd multiplication alone leaves behind.
    while (size >= 8) {
        std::uint64_t word;
        std::memcpy(&word, cursor, 8);
        m_state = (m_state ^ word) * kPrime;
        m_state ^= m_state >> 32;
        cursor += 8;
        size -= 8;
    }
    for (; size > 0; --size) m_state = (m_state ^ *cursor++) * kPrime;
}

std::uint64_t Hasher::digest() const {
    return mixedBits(m_state + m_length * 0x9e3779b97f4a7c15ull);
}

std::string Hasher::hex() const {
    return fmt::format("{:016x}", digest());
}

}  // namespace ombrage
