// SPDX-License-Identifier: MIT
#include "lab/statistics.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace ombrage {
namespace {

using Verdict = Difference::Verdict;

TEST(Statistics, KnownAnswers) {
    EXPECT_EQ(medianOf({}), 0);
    EXPECT_EQ(medianOf({3}), 3);
    EXPECT_EQ(medianOf({4, 1, 3, 2}), 2.5);
    EXPECT_EQ(medianOf({9, 1, 5}), 5);
    std::vector<double> hundred;
    for (int i = 100; i >= 1; --i) hundred.push_back(i);
    EXPECT_EQ(p95Of(hundred), 95);
    EXPECT_EQ(p95Of({7, 8}), 8);
    EXPECT_EQ(p95Of({}), 0);
    EXPECT_EQ(madOf({1, 1, 2, 2, 4, 6, 9}), 1);
    EXPECT_EQ(middleOf({6, 1, 2}), 3);
    EXPECT_EQ(middleOf({100, 1, 3, 4}), 3.5);
    EXPECT_EQ(middleOf({}), 0);
    // A quarter of the values may be anything.
    EXPECT_EQ(middleOf({1, 2, 3, 4, 5, 6, 7, 8}), middleOf({1, 2, 3, 4, 5, 6, 1e9, 1e9}));
}

TEST(Statistics, ExactDifferencesHaveExactIntervals) {
    const std::vector<double> a{1, 2, 3, 4, 5, 6, 7, 8};
    std::vector<double> b = a;
    for (double& value : b) value *= 1.25;
    const Difference same = pairedDifference(a, a, 1), more = pairedDifference(a, b, 1),
                     less = pairedDifference(b, a, 1);
    EXPECT_EQ(same.verdict, Verdict::None);
    EXPECT_EQ(same.change, 0);
    EXPECT_EQ(more.verdict, Verdict::More);
    // Rounding of exp and log.
    EXPECT_NEAR(more.change, 0.25, 1e-12);
    EXPECT_NEAR(more.low, 0.25, 1e-12);
    EXPECT_NEAR(more.high, 0.25, 1e-12);
    EXPECT_EQ(less.verdict, Verdict::Less);
    EXPECT_NEAR(less.change, -0.2, 1e-12);
}

TEST(Statistics, WhatIsCertainAndSmallDoesNotCount) {
    std::vector<double> a(20, 10.0), one(20, 10.19), two(20, 10.21);
    EXPECT_EQ(pairedDifference(a, one, 1).verdict, Verdict::None);
    EXPECT_GT(pairedDifference(a, one, 1).low, 0);
    EXPECT_EQ(pairedDifference(a, two, 1).verdict, Verdict::More);
}

TEST(Statistics, SevenRoundsAreTooFew) {
    const std::vector<double> a(7, 1.0), b(7, 2.0);
    EXPECT_EQ(pairedDifference(a, b, 1).verdict, Verdict::TooFew);
    EXPECT_EQ(unpairedDifference(a, b, 1).verdict, Verdict::TooFew);
    EXPECT_NEAR(pairedDifference(a, b, 1).change, 1.0, 1e-12);
}

TEST(Statistics, SameInputAndSeedSameOutput) {
    std::mt19937_64 random(1);
    std::vector<double> a, b;
    for (int i = 0; i < 25; ++i) {
        a.push_back(1 + double(random() % 1000) / 1000);
        b.push_back(1 + double(random() % 1000) / 1000);
    }
    EXPECT_EQ(pairedDifference(a, b, 5), pairedDifference(a, b, 5));
    EXPECT_NE(pairedDifference(a, b, 5), pairedDifference(a, b, 6));
}

// Of normal noise the interval covers the truth in 99 % of the cases, be the rounds 10 or 25.
TEST(Statistics, IntervalCoversAsOftenAsItSays) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> noise(0, 0.05);
    for (const int rounds : {10, 25}) {
        int covered = 0;
        constexpr int kTries = 300;
        for (int attempt = 0; attempt < kTries; ++attempt) {
            std::vector<double> a, b;
            for (int i = 0; i < rounds; ++i) {
                a.push_back(10 * std::exp(noise(random)));
                b.push_back(11 * std::exp(noise(random)));
            }
            const Difference d = pairedDifference(a, b, std::uint64_t(attempt));
            covered += d.low <= 0.1 && 0.1 <= d.high;
        }
        // The standard error of a share of 0.99 in 300 tries is 0.006: three of them.
        EXPECT_GE(covered, 291) << rounds;
        EXPECT_LT(covered, 300) << "an interval that is never wrong says nothing";
    }
}

/// Frame times as a busy machine gives them: a slow drift of 30 %, 6 % of noise skewed upwards, and in one frame of
/// twelve something else runs and takes as long as the frame or twice that. Blocks of frames by turns, order reversed
/// every other round.
struct NoisyMachine {
    /// What a bench takes when it is not told otherwise.
    static constexpr int kRounds = 25, kFrames = 5;
    explicit NoisyMachine(std::uint64_t seed) : random(seed) {}
    double frame(double cost) {
        now += cost;
        const double drift = 1 + 0.3 * std::sin(now / 900 + phase);
        const double skewed = std::abs(normal(random)) * 0.06;
        const double burst = random() % 12 == 0 ? 1 + double(random() % 2) : 0;
        return cost * drift * (1 + skewed + burst);
    }
    double block(double cost, int frames) {
        std::vector<double> times;
        for (int i = 0; i < frames; ++i) times.push_back(frame(cost));
        return medianOf(times);
    }
    Difference compare(double costA, double costB) {
        std::vector<double> a, b;
        for (int round = 0; round < kRounds; ++round) {
            for (const bool first : {true, false})
                if (first == (round % 2 == 0))
                    a.push_back(block(costA, kFrames));
                else
                    b.push_back(block(costB, kFrames));
        }
        return pairedDifference(a, b, 1);
    }
    std::mt19937_64 random;
    std::normal_distribution<double> normal;
    double now = 0, phase = double(random() % 628) / 100;
};

TEST(Statistics, TwinsAreNotToldApartOnABusyMachine) {
    // 49 of 50 is what is promised; 250 tries may then have 5 that fail.
    int told = 0;
    for (std::uint64_t seed = 0; seed < 250; ++seed)
        told += NoisyMachine(seed).compare(10, 10).verdict != Verdict::None;
    EXPECT_LE(told, 5);
}

TEST(Statistics, TenPercentAreFoundOnABusyMachine) {
    int found = 0;
    for (std::uint64_t seed = 0; seed < 250; ++seed)
        found += NoisyMachine(seed).compare(10, 11).verdict == Verdict::More;
    EXPECT_GE(found, 245);
}

TEST(Statistics, ExactDriftIsNoDifferenceWhenPairedButIsOneWhenNot) {
    std::vector<double> early, late;
    for (int i = 0; i < 20; ++i) {
        early.push_back(10 + 0.01 * (i % 3));
        late.push_back(12 + 0.01 * (i % 4));
    }
    EXPECT_EQ(unpairedDifference(early, late, 1).verdict, Verdict::More);
    std::vector<double> a = early, b = early;
    a.insert(a.end(), late.begin(), late.end());
    b.insert(b.end(), late.begin(), late.end());
    EXPECT_EQ(pairedDifference(a, b, 1).verdict, Verdict::None);
}

}  // namespace
}  // namespace ombrage
