// SPDX-License-Identifier: MIT
#include "core/sobol.h"

#include <array>
#include <cassert>

#include "core/hash.h"

namespace ombrage {
namespace {

using Directions = std::array<std::uint32_t, 32>;

/// Direction numbers of one dimension from its primitive polynomial of degree s with inner coefficients a, and the
/// first s odd numbers m (Joe and Kuo 2008, equations 2 and 3).
constexpr Directions directions(int s, std::uint32_t a, std::array<std::uint32_t, 3> m) {
    Directions v{};
    // The first s numbers are given.
    for (int i = 0; i < s; ++i) v[i] = m[i] << (31 - i);
    // The others follow by the recurrence over the polynomial.
    for (int i = s; i < 32; ++i) {
        v[i] = v[i - s] ^ (v[i - s] >> s);
        for (int k = 1; k < s; ++k)
            if ((a >> (s - 1 - k)) & 1u) v[i] ^= v[i - k];
    }
    return v;
}

constexpr Directions vanDerCorput() {
    Directions v{};
    for (int i = 0; i < 32; ++i) v[i] = 1u << (31 - i);
    return v;
}

/// The sums of direction numbers for every value of each of the four bytes of an index: a shuffled index has all of its
/// bits set at random, and four look-ups are ten times as fast as a loop over them.
using ByteSums = std::array<std::array<std::uint32_t, 256>, 4>;

constexpr ByteSums byteSums(const Directions& v) {
    ByteSums sums{};
    for (std::size_t byte = 0; byte < 4; ++byte)
        for (std::size_t value = 1; value < 256; ++value) {
            // The value without its lowest set bit is known.
            std::size_t bit = 0;
            while (!((value >> bit) & 1u)) ++bit;
            sums[byte][value] = sums[byte][value & (value - 1)] ^ v[8 * byte + bit];
        }
    return sums;
}

constexpr std::array<ByteSums, kSobolDimensions> kSums = {
    byteSums(vanDerCorput()), byteSums(directions(1, 0, {1, 0, 0})), byteSums(directions(2, 1, {1, 3, 0})),
    byteSums(directions(3, 1, {1, 3, 1}))};

constexpr std::uint32_t reverseBits(std::uint32_t x) {
    x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
    x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
    x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
    x = ((x >> 8) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8);
    return (x >> 16) | (x << 16);
}

/// The largest floats below 1 keep the result inside [0,1): the upper 24 bits only.
float unitFloat(std::uint32_t bits) {
    return float(bits >> 8) * 0x1p-24f;
}

}  // namespace

std::uint32_t sobol(std::uint32_t index, int dimension) {
    assert(dimension >= 0 && dimension < kSobolDimensions);
    const ByteSums& sums = kSums[std::size_t(dimension)];
    return sums[0][index & 255u] ^ sums[1][(index >> 8) & 255u] ^ sums[2][(index >> 16) & 255u] ^ sums[3][index >> 24];
}

std::uint32_t owenScramble(std::uint32_t bits, std::uint32_t seed) {
    // Every step lets a bit depend only on lower bits, so between two reversals on higher ones: a nested scrambling.
    std::uint32_t x = reverseBits(bits);
    x += seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    x ^= x * 0x8d22f6e6u;
    return reverseBits(x);
}

glm::vec2 owenSobol2(std::uint32_t index, std::uint32_t seed, int dimensionPair) {
    // Each pair has its own shuffle and its own scrambling per dimension (Burley 2020, section 5).
    assert(dimensionPair >= 0);
    const std::uint32_t pairSeed = hashCombine(seed, std::uint32_t(dimensionPair));
    const std::uint32_t shuffled = owenScramble(index, pairSeed);
    const int first = 2 * (dimensionPair % 2);
    return {unitFloat(owenScramble(sobol(shuffled, first), hashCombine(pairSeed, 1))),
            unitFloat(owenScramble(sobol(shuffled, first + 1), hashCombine(pairSeed, 2)))};
}

std::uint32_t hashCombine(std::uint32_t a, std::uint32_t b) {
    // Both words enter one 64-bit word, mixed.
    return std::uint32_t(mixedBits((std::uint64_t(a) << 32 | b) + 0x9e3779b97f4a7c15ull) >> 32);
}

}  // namespace ombrage
