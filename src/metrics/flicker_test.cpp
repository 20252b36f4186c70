// SPDX-License-Identifier: MIT
#include "metrics/flicker.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <ombrage/error.h>

namespace ombrage {
namespace {

constexpr double kTolerance = 0.1;

ErrorFrame frameOf(std::vector<float> error) {
    const std::size_t count = error.size();
    return {std::move(error), std::vector<bool>(count, true)};
}

std::vector<bool> marks(const std::vector<std::string>& rows) {
    std::vector<bool> marked;
    for (const std::string& row : rows)
        for (const char c : row) marked.push_back(c == '#');
    return marked;
}

TEST(LargestPatchTest, CountsWhatHangsTogetherByEdgesAndCorners) {
    EXPECT_EQ(largestPatch(marks({"....", "...."}), 4, 2), 0u);
    // A diagonal of 3, a block of 4, one by itself.
    EXPECT_EQ(largestPatch(marks({"#...##", ".#..##", "..#...", "......", "#....."}), 6, 5), 4u);
    EXPECT_EQ(largestPatch(marks({"#...", ".#..", "..#.", "...#"}), 4, 4), 4u);
    // The last column and the first of the next row are no neighbours.
    EXPECT_EQ(largestPatch(marks({"...#", "....", "#..."}), 4, 3), 1u);
    EXPECT_EQ(largestPatch(marks({"...#", "#..."}), 4, 2), 1u);
    EXPECT_EQ(largestPatch(std::vector<bool>(200 * 100, true), 200, 100), 20000u);
}

TEST(FlickerTest, AConstantErrorDoesNotFlicker) {
    FlickerMeter meter(2, 2, kTolerance);
    for (int i = 0; i < 3; ++i) meter.add(frameOf({0.5f, -1.0f, 0.0f, 0.25f}));
    const Flicker flicker = meter.result();
    EXPECT_EQ(flicker.mean, 0.0);
    EXPECT_EQ(flicker.p99, 0.0);
    EXPECT_EQ(flicker.patch_px, 0u);
}

TEST(FlickerTest, MeansOverPairsAndPoints) {
    FlickerMeter meter(4, 1, kTolerance);
    meter.add(frameOf({0, 0, 0, 0}));
    meter.add(frameOf({0.5f, -0.25f, 0, 0}));
    meter.add(frameOf({0.5f, 0.25f, 0, 0.05f}));
    const Flicker flicker = meter.result();
    // 0.5 + 0.25 in the first pair, 0.5 + 0.05 in the second, over 8; floats of halves add up exactly but for 0.05f.
    EXPECT_NEAR(*flicker.mean, 1.3 / 8, 1e-8);
    EXPECT_EQ(flicker.p99, 0.5);
    // Two neighbours in the first pair; 0.05 is within the tolerance.
    EXPECT_EQ(flicker.patch_px, 2u);
    EXPECT_EQ(flicker.largest, (std::vector<float>{0.5f, 0.5f, 0, 0.05f}));
}

TEST(FlickerTest, ThePercentileIsTheNearestRank) {
    // 1 of 100 changes: 99 of 100 do not exceed 0. 2 of 100: the 99th is the smaller of them.
    for (const int changed : {1, 2}) {
        FlickerMeter meter(100, 1, kTolerance);
        std::vector<float> error(100, 0.0f);
        meter.add(frameOf(error));
        for (int i = 0; i < changed; ++i) error[std::size_t(i)] = 0.75f - 0.25f * float(i);
        meter.add(frameOf(error));
        EXPECT_EQ(meter.result().p99, changed == 1 ? 0.0 : 0.5);
    }
}

TEST(FlickerTest, CountsPointsThatAreValidInBothFrames) {
    FlickerMeter meter(3, 1, kTolerance);
    meter.add({{0, 0, 0}, {true, true, false}});
    meter.add({{1, 1, 1}, {true, false, true}});
    meter.add({{1, 0, 0}, {false, true, true}});
    // The first pair counts the first point (1), the second the last (1).
    const Flicker flicker = meter.result();
    EXPECT_EQ(flicker.mean, 1.0);
    EXPECT_EQ(flicker.seen, (std::vector<bool>{true, false, true}));

    FlickerMeter blind(1, 1, kTolerance);
    blind.add({{0}, {true}});
    EXPECT_FALSE(blind.result().mean);
    blind.add({{1}, {false}});
    EXPECT_FALSE(blind.result().mean);
    EXPECT_FALSE(blind.result().p99);
    EXPECT_FALSE(blind.result().patch_px);
    EXPECT_THROW(blind.add({{1, 2}, {false, false}}), Error);
}

TEST(FlickerTest, WhatIsNotANumberCountsAsWrongAsCanBe) {
    FlickerMeter meter(1, 1, kTolerance);
    meter.add(frameOf({0}));
    meter.add(frameOf({std::numeric_limits<float>::quiet_NaN()}));
    EXPECT_EQ(meter.result().mean, 1.0);
    EXPECT_EQ(meter.result().patch_px, 1u);
}

/// Answers that follow a jump from 0 to 1 after `late` of `count` frames, at 200 points of which `strays` never do.
std::optional<Lag> lagAfter(int late, int count, int strays) {
    std::vector<std::vector<float>> answers, settled;
    for (int f = 0; f < count; ++f) {
        answers.emplace_back(200, f < late ? 0.0f : 1.0f);
        for (int i = 0; i < strays; ++i) answers.back()[std::size_t(i)] = 0.0f;
        settled.emplace_back(200, 1.0f);
    }
    return lagOf(answers, settled, kTolerance);
}

TEST(LagTest, CountsFramesUntilTheAnswerStaysWithinTheTolerance) {
    EXPECT_EQ(lagAfter(0, 8, 0)->frames, 0);
    EXPECT_EQ(lagAfter(3, 8, 0)->frames, 3);
    EXPECT_TRUE(lagAfter(3, 8, 0)->settled);
    EXPECT_EQ(lagAfter(8, 8, 0)->frames, 8);
    EXPECT_FALSE(lagAfter(8, 8, 0)->settled);
    // One in a hundred may stray.
    EXPECT_EQ(lagAfter(3, 8, 2)->frames, 3);
    EXPECT_FALSE(lagAfter(3, 8, 3)->settled);
    EXPECT_FALSE(lagOf({}, {}, kTolerance));
    EXPECT_FALSE(lagOf({{}}, {{}}, kTolerance));
    EXPECT_THROW(lagOf({{1}}, {}, kTolerance), Error);
}

TEST(LagTest, AnAnswerThatComesNearSlowlyCountsFromTheTolerance) {
    // 1 - 2^-(f+1): within 0.1 from the fourth frame (0.0625) on.
    std::vector<std::vector<float>> answers;
    for (int f = 0; f < 8; ++f) answers.push_back({1.0f - std::ldexp(1.0f, -(f + 1))});
    EXPECT_EQ(lagOf(answers, std::vector<std::vector<float>>(8, {1.0f}), kTolerance)->frames, 3);
    // Right at first and off again later: it has not settled before the last time.
    std::vector<std::vector<float>> relapse(8, {1.0f});
    relapse[5] = {0.0f};
    EXPECT_EQ(lagOf(relapse, std::vector<std::vector<float>>(8, {1.0f}), kTolerance)->frames, 6);
}

TEST(NearestOfTriangleTest, TakesTheSameTriangleAround) {
    Receivers receivers;
    receivers.width = 3;
    receivers.height = 1;
    receivers.instance = {0, 0, kNoHit};
    receivers.triangle = {7, 8, kNoHit};
    const std::vector<std::uint32_t> instance{0, 0, 0}, triangle{8, 7, 7};
    // Triangle 7 stands one and two pixels to the right, 8 one to the left; sky is not followed.
    const std::vector<glm::dvec2> places{{1.6, 0.5}, {0.9, 0.5}, {2.5, 0.5}};
    EXPECT_EQ(nearestOfTriangle(receivers, places, instance, triangle), (std::vector<std::ptrdiff_t>{1, 0, -1}));
    // Out of the picture, behind the camera, and more than a pixel away.
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<glm::dvec2> lost{{nan, nan}, {-0.1, 0.5}, {0, 0}};
    EXPECT_EQ(nearestOfTriangle(receivers, lost, instance, triangle), (std::vector<std::ptrdiff_t>{-1, -1, -1}));
    const std::vector<glm::dvec2> far{{0.5, 0.5}, {2.5, 0.5}, {0, 0}};
    EXPECT_EQ(nearestOfTriangle(receivers, far, instance, triangle), (std::vector<std::ptrdiff_t>{1, -1, -1}));
}

}  // namespace
}  // namespace ombrage
