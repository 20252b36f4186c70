// SPDX-License-Identifier: MIT
#include "render/statistics.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace ombrage {
namespace {

TEST(Statistics, NoSamplesGiveZero) {
    EXPECT_EQ(statsOf({}).median, 0);
    EXPECT_EQ(statsOf({}).p95, 0);
}

TEST(Statistics, OneSampleIsBoth) {
    EXPECT_EQ(statsOf({7}).median, 7);
    EXPECT_EQ(statsOf({7}).p95, 7);
}

TEST(Statistics, TheMedianOfAnEvenNumberIsTheMiddle) {
    EXPECT_EQ(statsOf({4, 1, 3, 2}).median, 2.5);
    EXPECT_EQ(statsOf({5, 1, 3}).median, 3);
}

TEST(Statistics, The95thPercentileIsTheNearestRank) {
    // Rank ceil(0.95 n), counted from 1.
    for (const auto& [count, rank] :
         std::initializer_list<std::pair<int, int>>{{10, 10}, {19, 19}, {20, 19}, {21, 20}, {100, 95}, {101, 96}}) {
        std::vector<double> samples;
        for (int i = 1; i <= count; ++i) samples.push_back(i);
        std::shuffle(samples.begin(), samples.end(), std::mt19937(1));
        EXPECT_EQ(statsOf(samples).p95, rank) << count;
    }
}

TEST(Statistics, ThreadTimeGrowsWithWork) {
    const double start = threadTime_ms();
    volatile double sum = 0;
    while (threadTime_ms() - start < 2) sum = sum + 1;
    EXPECT_GE(threadTime_ms() - start, 2);
}

}  // namespace
}  // namespace ombrage
