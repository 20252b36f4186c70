// SPDX-License-Identifier: MIT
#include "core/blue_noise.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

namespace ombrage {
namespace {

constexpr int kSize = 32;

/// Power of a square's values (0 to 1, mean taken off) over the frequencies from `from` to `to` cycles, per frequency.
double powerBetween(const std::vector<std::uint32_t>& ranks, double from, double to) {
    double power = 0;
    int count = 0;
    for (int v = 0; v < kSize; ++v)
        for (int u = 0; u < kSize; ++u) {
            const double fu = std::min(u, kSize - u), fv = std::min(v, kSize - v), f = std::hypot(fu, fv);
            if (f < from || f > to) continue;
            double re = 0, im = 0;
            for (int y = 0; y < kSize; ++y)
                for (int x = 0; x < kSize; ++x) {
                    const double value = (ranks[std::size_t(y * kSize + x)] + 0.5) / (kSize * kSize) - 0.5;
                    const double angle = 2 * M_PI * (u * x + v * y) / kSize;
                    re += value * std::cos(angle);
                    im += value * std::sin(angle);
                }
            power += re * re + im * im;
            ++count;
        }
    return power / count;
}

TEST(BlueNoise, HoldsEveryRankOnceAndFollowsTheSeed) {
    std::vector<std::uint32_t> ranks = blueNoise(kSize, 1);
    EXPECT_EQ(ranks, blueNoise(kSize, 1));
    EXPECT_NE(ranks, blueNoise(kSize, 2));
    std::sort(ranks.begin(), ranks.end());
    std::vector<std::uint32_t> all(std::size_t(kSize) * kSize);
    std::iota(all.begin(), all.end(), 0u);
    EXPECT_EQ(ranks, all);
}

TEST(BlueNoise, HasHardlyAnyLowFrequencies) {
    const std::vector<std::uint32_t> ranks = blueNoise(kSize, 1);
    // White noise of this variance has the same power everywhere: 1/12 per place, times their number.
    const double white = kSize * kSize / 12.0;
    EXPECT_LT(powerBetween(ranks, 1, 4), 0.1 * white);
    EXPECT_GT(powerBetween(ranks, 12, 23), white);
}

TEST(BlueNoise, AnyShareOfItIsSpreadEvenly) {
    const std::vector<std::uint32_t> ranks = blueNoise(kSize, 3);
    for (const std::uint32_t share : {64u, 256u, 512u}) {
        // Eight by eight blocks: by chance their numbers would scatter by the square root of the mean.
        const double mean = share / 16.0;
        double squares = 0;
        for (int block = 0; block < 16; ++block) {
            double count = 0;
            for (int y = 0; y < 8; ++y)
                for (int x = 0; x < 8; ++x)
                    count += ranks[std::size_t((block / 4 * 8 + y) * kSize + block % 4 * 8 + x)] < share ? 1 : 0;
            squares += (count - mean) * (count - mean);
        }
        EXPECT_LT(squares / 16, 0.5 * mean) << share;
    }
}

}  // namespace
}  // namespace ombrage
