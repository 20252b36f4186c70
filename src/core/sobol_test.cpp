// SPDX-License-Identifier: MIT
#include "core/sobol.h"

#include <bit>
#include <cmath>
#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace ombrage {
namespace {

/// Whether 2^m points put exactly one into each elementary interval of volume 2^-m: a (0,m,2)-net in base 2.
template <typename Point>
bool isNet(int m, Point point) {
    for (int k = 0; k <= m; ++k) {
        std::vector<int> counts(std::size_t(1) << m, 0);
        for (std::uint32_t i = 0; i < 1u << m; ++i) {
            const glm::uvec2 p = point(i);
            const std::uint32_t column = k == 0 ? 0 : p.x >> (32 - k);
            const std::uint32_t row = k == m ? 0 : p.y >> (32 - (m - k));
            if (++counts[std::size_t(column) << (m - k) | row] > 1) return false;
        }
    }
    return true;
}

glm::uvec2 bits(glm::vec2 p) {
    return {std::uint32_t(p.x * 0x1p24f) << 8, std::uint32_t(p.y * 0x1p24f) << 8};
}

TEST(Sobol, FirstPointsAreThePublishedOnes) {
    // Natural (not Gray code) order; values in 1/8 from the direction numbers by hand.
    const int expected[8][4] = {{0, 0, 0, 0}, {4, 4, 4, 4}, {2, 6, 6, 6}, {6, 2, 2, 2},
                                {1, 5, 3, 1}, {5, 1, 7, 5}, {3, 3, 5, 7}, {7, 7, 1, 3}};
    for (std::uint32_t i = 0; i < 8; ++i)
        for (int d = 0; d < 4; ++d) EXPECT_EQ(sobol(i, d) >> 29, std::uint32_t(expected[i][d])) << i << " " << d;
}

TEST(Sobol, EveryDimensionIsAPermutationOfEachPowerOfTwo) {
    for (int d = 0; d < kSobolDimensions; ++d) {
        std::set<std::uint32_t> seen;
        for (std::uint32_t i = 0; i < 256; ++i) seen.insert(sobol(i, d) >> 24);
        EXPECT_EQ(seen.size(), 256u) << d;
    }
}

TEST(Sobol, FirstTwoDimensionsAreANet) {
    for (int m = 0; m <= 10; ++m)
        EXPECT_TRUE(isNet(m, [](std::uint32_t i) { return glm::uvec2(sobol(i, 0), sobol(i, 1)); })) << m;
}

TEST(Sobol, ScrambledAndShuffledFirstTwoDimensionsAreANet) {
    for (std::uint32_t seed : {0u, 1u, 77u, 0xffffffffu})
        for (int m = 0; m <= 10; ++m)
            EXPECT_TRUE(isNet(m, [seed](std::uint32_t i) { return bits(owenSobol2(i, seed)); })) << m << " " << seed;
}

TEST(Sobol, ScramblingKeepsElementaryIntervalsTogether) {
    // Two numbers that share exactly k leading bits still do after an Owen scrambling.
    std::mt19937 random(3);
    for (int n = 0; n < 2000; ++n) {
        const std::uint32_t a = std::uint32_t(random()), b = a ^ (std::uint32_t(random()) >> (n % 31));
        const std::uint32_t sa = owenScramble(a, 99), sb = owenScramble(b, 99);
        EXPECT_EQ(std::countl_zero(a ^ b), std::countl_zero(sa ^ sb));
    }
}

TEST(Sobol, SeedsDecideThePoints) {
    EXPECT_EQ(owenSobol2(5, 1), owenSobol2(5, 1));
    EXPECT_NE(owenSobol2(5, 1), owenSobol2(5, 2));
    EXPECT_NE(owenSobol2(5, 1, 0), owenSobol2(5, 1, 1));
    EXPECT_NE(owenSobol2(5, 1, 0), owenSobol2(5, 1, 2));
    EXPECT_NE(hashCombine(1, 2), hashCombine(2, 1));
}

TEST(Sobol, PointsStayInTheUnitSquare) {
    for (std::uint32_t i = 0; i < 20000; ++i) {
        const glm::vec2 p = owenSobol2(i, 0xdeadbeef, int(i % 5));
        ASSERT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1);
    }
}

TEST(Sobol, HashFlipsHalfOfTheBits) {
    // 32 x 2000 trials of a fair coin per output word: mean 16, standard deviation of the mean 0.011; 0.1 is 9 of them.
    double flipped = 0;
    for (std::uint32_t n = 0; n < 2000; ++n)
        for (int bit = 0; bit < 32; ++bit)
            flipped += std::popcount(hashCombine(n, 7) ^ hashCombine(n ^ (1u << bit), 7));
    EXPECT_NEAR(flipped / (2000.0 * 32), 16.0, 0.1);
}

TEST(Sobol, IntegratesADiskFasterThanRandomPoints) {
    // Root mean square error over 64 seeds of the area of a quarter disk from 1024 points. Independent points have
    // sqrt(p(1-p)/n) = 0.0128; scrambled nets have about n^(-3/4) = 0.006 times a small factor: under a third.
    const double exact = 0.78539816339744831;
    double sobolSquare = 0;
    for (std::uint32_t seed = 0; seed < 64; ++seed) {
        int inside = 0;
        for (std::uint32_t i = 0; i < 1024; ++i) {
            const glm::vec2 p = owenSobol2(i, seed);
            inside += p.x * p.x + p.y * p.y < 1;
        }
        sobolSquare += (inside / 1024.0 - exact) * (inside / 1024.0 - exact);
    }
    EXPECT_LT(std::sqrt(sobolSquare / 64), 0.0128 / 3);
}

TEST(Sobol, ScramblingsAreUnbiased) {
    // The mean of the first point over 4096 scramblings: 0.5 with standard error 1/sqrt(12*4096) = 0.0045; 4 of them.
    glm::dvec2 sum(0);
    for (std::uint32_t seed = 0; seed < 4096; ++seed) sum += glm::dvec2(owenSobol2(0, hashCombine(seed, 0)));
    EXPECT_NEAR(sum.x / 4096, 0.5, 0.018);
    EXPECT_NEAR(sum.y / 4096, 0.5, 0.018);
}

}  // namespace
}  // namespace ombrage
