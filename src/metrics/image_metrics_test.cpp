// SPDX-License-Identifier: MIT
#include "metrics/image_metrics.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include <gtest/gtest.h>
#include <ombrage/error.h>

namespace ombrage {
namespace {

AoTruth truthOf(int width, int height, std::vector<float> values) {
    AoTruth t;
    t.width = width;
    t.height = height;
    t.mask.assign(values.size(), Mask::Valid);
    t.standardError.assign(values.size(), 0.0f);
    t.visibility = std::move(values);
    return t;
}

TEST(ImageMetrics, HandComputedCase) {
    const AoTruth truth = truthOf(4, 1, {0.0f, 0.5f, 1.0f, 0.5f});
    const std::vector<float> picture{0.25f, 0.5f, 0.5f, 0.5f};
    const Metrics m = measureAo(picture, truth);
    // Errors 1/4, 0, -1/2, 0; the truth's variance is 1/8.
    EXPECT_DOUBLE_EQ(*m.at("mae"), 0.1875);
    EXPECT_DOUBLE_EQ(*m.at("rmse"), std::sqrt(0.3125 / 4));
    EXPECT_DOUBLE_EQ(*m.at("bias"), -0.0625);
    EXPECT_DOUBLE_EQ(*m.at("p95"), 0.5);
    EXPECT_DOUBLE_EQ(*m.at("psnr"), -10 * std::log10(0.078125));
    EXPECT_DOUBLE_EQ(*m.at("gain_db"), -10 * std::log10(0.078125) + 10 * std::log10(0.125));
}

TEST(ImageMetrics, IdenticalImagesAreExact) {
    std::vector<float> values(400);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = float(i % 7) / 6;
    const Metrics m = measureAo(values, truthOf(20, 20, values));
    EXPECT_EQ(*m.at("mae"), 0);
    EXPECT_EQ(*m.at("rmse"), 0);
    EXPECT_EQ(*m.at("psnr"), 99);
    EXPECT_EQ(*m.at("ssim"), 1);
}

TEST(Residual, IsWhatIsLeftWithoutTheMedianWhereTheTruthIsFlat) {
    // Left half: a truth of 0.5, right: a ramp. In the picture every fifth pixel of a row is off by 0.25.
    constexpr int kWidth = 80, kHeight = 40;
    std::vector<float> values, picture;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            values.push_back(x < 40 ? 0.5f : 0.5f + float(x - 40) / 100);
            picture.push_back(values.back() + (x % 5 == 0 ? 0.25f : 0.0f));
        }
    const AoTruth truth = truthOf(kWidth, kHeight, values);
    // The windows about columns 7 to 32 lie in the left half, and those to 37 hold a rise of standard deviation below
    // 0.02; of these 31 the 6 of 10, 15, ... 35 are off, and a fifth of each window's pixels moves no median by more
    // than the ramp does, 0.01.
    EXPECT_NEAR(*residual(picture, truth), 0.25 * std::sqrt(6.0 / 31), 0.005);
    EXPECT_EQ(*residual(std::vector<float>(values.size(), 0.25f), truth), 0);
    // A noisy truth makes the ramp flat, too: the columns 7 to 72, of which 13 are off.
    AoTruth noisy = truth;
    noisy.standardError.assign(values.size(), 0.03f);
    EXPECT_NEAR(*residual(picture, noisy), 0.25 * std::sqrt(13.0 / 66), 0.005);
}

TEST(Residual, NeedsAFlatWindow) {
    AoTruth truth = truthOf(40, 40, std::vector<float>(1600, 0.5f));
    EXPECT_FALSE(residual(std::vector<float>(100, 0.5f), truthOf(10, 10, std::vector<float>(100, 0.5f))));
    EXPECT_TRUE(residual(truth.visibility, truth));
    for (int i = 0; i < 1600; i += 7) truth.mask[std::size_t(i)] = Mask::Sky;
    EXPECT_FALSE(residual(truth.visibility, truth));
    EXPECT_THROW(residual(std::vector<float>(3), truth), Error);
}

TEST(ImageMetrics, ConstantOffset) {
    std::vector<float> values(400), offset(400);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = float(i % 2) * 0.5f, offset[i] = values[i] + 0.125f;
    const Metrics m = measureAo(offset, truthOf(20, 20, values));
    EXPECT_EQ(*m.at("mae"), 0.125);
    EXPECT_EQ(*m.at("rmse"), 0.125);
    EXPECT_EQ(*m.at("bias"), 0.125);
    EXPECT_EQ(*m.at("p95"), 0.125);
    EXPECT_NEAR(*m.at("psnr"), 18.0618, 1e-4);
    // The best constant is off by 1/4 everywhere: 6.02 dB worse.
    EXPECT_NEAR(*m.at("gain_db"), 6.0206, 1e-4);
}

TEST(ImageMetrics, TheBestConstantGainsNothing) {
    std::vector<float> values(100);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = float(i) / 99;
    const std::vector<float> constant(100, 0.5f);
    EXPECT_NEAR(*measureAo(constant, truthOf(10, 10, values)).at("gain_db"), 0, 1e-9);
}

TEST(ImageMetrics, MaskedPixelsDoNotCount) {
    AoTruth truth = truthOf(4, 1, {0, 0, 1, 1});
    truth.mask[3] = Mask::Sky;
    const Metrics m = measureAo(std::vector<float>{0, 0, 1, -50}, truth);
    EXPECT_EQ(*m.at("rmse"), 0);
    EXPECT_EQ(*m.at("ssim"), 1);
}

TEST(ImageMetrics, NoValidPixelIsNull) {
    AoTruth truth = truthOf(2, 1, {0, 1});
    truth.mask = {Mask::Sky, Mask::Disagree};
    for (const auto& [key, value] : measureAo(std::vector<float>{0, 1}, truth)) EXPECT_FALSE(value) << key;
}

TEST(ImageMetrics, WhatIsNoNumberIsWrong) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const Metrics m = measureAo(std::vector<float>{nan, nan}, truthOf(2, 1, {0, 1}));
    EXPECT_EQ(*m.at("mae"), 1);
    EXPECT_TRUE(std::isfinite(*m.at("ssim")));
}

TEST(ImageMetrics, SizesMustAgree) {
    EXPECT_THROW(measureAo(std::vector<float>{0, 1, 1}, truthOf(2, 1, {0, 1})), Error);
}

TEST(ImageMetrics, PercentileIsTheNearestRank) {
    std::vector<float> values(100);
    std::iota(values.begin(), values.end(), 1.0f);
    EXPECT_EQ(percentile(values, 0.95), 95);
    EXPECT_EQ(percentile({3}, 0.95), 3);
    EXPECT_EQ(percentile({}, 0.95), 0);
}

TEST(Ssim, ConstantImagesHaveTheLuminanceTermAlone) {
    const std::vector<float> a(400, 0.25f), b(400, 0.75f);
    // (2 ab + C1) / (a^2 + b^2 + C1) with C1 = 1e-4; 1e-6: the map is kept in float.
    EXPECT_NEAR(*ssim(a, b, 20, 20, {}), (0.375 + 1e-4) / (0.625 + 1e-4), 1e-6);
}

TEST(Ssim, OneWindowByHand) {
    // A picture of one window: a step, and the same step inverted. Means and variances of the 11 Gaussian columns.
    std::vector<float> a(121), b(121);
    double weight = 0, mean = 0;
    for (int x = 0; x < 11; ++x) {
        const double w = std::exp(-(x - 5) * (x - 5) / 4.5);
        weight += w;
        mean += x < 5 ? 0 : w;
        for (int y = 0; y < 11; ++y) {
            a[std::size_t(y * 11 + x)] = x < 5 ? 0.0f : 1.0f;
            b[std::size_t(y * 11 + x)] = x < 5 ? 1.0f : 0.0f;
        }
    }
    mean /= weight;
    const double other = 1 - mean, variance = mean - mean * mean, c1 = 1e-4, c2 = 9e-4;
    const double expected =
        (2 * mean * other + c1) * (-2 * variance + c2) / ((mean * mean + other * other + c1) * (2 * variance + c2));
    EXPECT_NEAR(*ssim(a, b, 11, 11, {}), expected, 1e-6);
}

TEST(Ssim, NoiseLowersItAndOnlyWhereItIs) {
    std::mt19937 random(1);
    std::vector<float> a(64 * 64), b;
    for (float& v : a) v = float(random() % 1000) / 999;
    b = a;
    for (std::size_t i = 0; i < b.size(); ++i)
        if (i % 64 < 32) b[i] = float(random() % 1000) / 999;
    std::vector<Mask> left(a.size()), right(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        left[i] = i % 64 < 32 ? Mask::Valid : Mask::Sky;
        right[i] = i % 64 < 32 ? Mask::Sky : Mask::Valid;
    }
    // Independent noise has no structure in common but the mean; masked pixels do not leak into the windows.
    EXPECT_LT(*ssim(a, b, 64, 64, left), 0.2);
    EXPECT_EQ(*ssim(a, b, 64, 64, right), 1.0);
}

TEST(Ssim, SmallPicturesAndEmptyMasks) {
    EXPECT_EQ(*ssim(std::vector<float>{0.5f}, std::vector<float>{0.5f}, 1, 1, {}), 1.0);
    EXPECT_FALSE(ssim(std::vector<float>{0.5f}, std::vector<float>{0.5f}, 1, 1, {Mask::Sky}));
    EXPECT_THROW(ssim(std::vector<float>{0.5f}, std::vector<float>{}, 1, 1, {}), Error);
}

}  // namespace
}  // namespace ombrage
