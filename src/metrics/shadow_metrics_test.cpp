// SPDX-License-Identifier: MIT
// Planted defects on synthetic truths: each must come out as its own class and as no other.
#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>
#include <ombrage/error.h>
#include <ombrage/metrics.h>

#include "metrics/distance_transform.h"
#include "metrics/planted_case.h"
#include "metrics/shadow_edges.h"

namespace ombrage::test {
namespace {

const std::vector<std::string> kClasses{"missing", "contact_gap", "alias",        "over_blur", "under_blur",
                                        "acne",    "leak",        "false_shadow", "other"};

/// Every over pixel is of the one class.
void expectOnly(const ShadowMeasurement& m, const std::string& key, double share) {
    EXPECT_DOUBLE_EQ(*m.metrics.at("over"), share);
    for (const auto& k : kClasses) EXPECT_DOUBLE_EQ(*m.metrics.at(k), k == key ? share : 0.0) << k;
}

TEST(ShadowMetrics, TheTruthItselfHasNoError) {
    const Case c;
    const ShadowMeasurement m = c.measure();
    EXPECT_EQ(m.validCount, kCount);
    for (const char* key : {"mae", "rmse", "bias", "p95", "wrong", "wrong_domain", "wrong_lit", "over", "leak_mass",
                            "rmse_lit", "edge_px"})
        EXPECT_EQ(*m.metrics.at(key), 0) << key;
    EXPECT_EQ(*m.metrics.at("psnr"), 99);
    EXPECT_EQ(*m.metrics.at("ssim"), 1);
    expectOnly(m, "other", 0);
    EXPECT_EQ(std::count(m.classes.begin(), m.classes.end(), ErrorClass::None), std::ptrdiff_t(kCount));
}

TEST(ShadowMetrics, StripesInTheLightAreAcne) {
    Case c;
    int planted = 0;
    for (int y = 0; y < kHeight; y += 3)
        for (int x = 0; x < 20; ++x, ++planted) c.picture[c.at(x, y)] = 0;
    // Without texels there is no depth that the surface itself could lie at.
    expectOnly(c.measure(), "false_shadow", double(planted) / kCount);
    const ShadowMeasurement m = c.measure(withTexels(kFineTexels));
    expectOnly(m, "acne", double(planted) / kCount);
    EXPECT_EQ(m.classes[c.at(5, 3)], ErrorClass::Acne);
    EXPECT_DOUBLE_EQ(*m.metrics.at("wrong"), double(planted) / kCount);
}

TEST(ShadowMetrics, ADisplacedEdgeIsAlias) {
    // Two pixels too far left: the farthest is 2 px from the edge pixel.
    Case c;
    for (int y = 0; y < kHeight; ++y) c.picture[c.at(kWidth / 2 - 1, y)] = c.picture[c.at(kWidth / 2 - 2, y)] = 0;
    expectOnly(c.measure(), "alias", 2.0 / kWidth);

    // Ten pixels: alias for a texel as large, a false shadow without texels.
    for (int y = 0; y < kHeight; ++y)
        for (int x = kWidth / 2 - 10; x < kWidth / 2; ++x) c.picture[c.at(x, y)] = 0;
    TexelFootprint coarse;
    coarse.texel_m = 0.1;
    expectOnly(c.measure(withTexels(coarse)), "alias", 10.0 / kWidth);
    const ShadowMeasurement fine = c.measure();
    EXPECT_DOUBLE_EQ(*fine.metrics.at("alias"), 3.0 / kWidth);
    EXPECT_DOUBLE_EQ(*fine.metrics.at("false_shadow"), 7.0 / kWidth);
}

TEST(ShadowMetrics, KernelDistanceAndGrazingLightWidenTheAliasZone) {
    Case c;
    for (int y = 0; y < kHeight; ++y) c.picture[c.at(kWidth / 2 - 9, y)] = 0;  // 8 px from the edge pixel
    const auto alias = [&](const TexelFootprint& footprint) {
        return *c.measure(withTexels(footprint)).metrics.at("alias") > 0;
    };
    TexelFootprint f;
    f.texel_m = 0.02;  // 2 pixels
    EXPECT_FALSE(alias(f));
    f.kernelRadius_texels = 3;
    EXPECT_TRUE(alias(f));
    f.kernelRadius_texels = 0;
    std::fill(c.truth.cosine.begin(), c.truth.cosine.end(), 0.25f);
    EXPECT_TRUE(alias(f));
    // The same of a lamp 4 m away.
    std::fill(c.truth.cosine.begin(), c.truth.cosine.end(), 1.0f);
    std::fill(c.truth.lightDistance_m.begin(), c.truth.lightDistance_m.end(), 4.0f);
    f = {};
    f.texelPerMetre = 0.005;
    EXPECT_FALSE(alias(f));
    f.texelPerMetre = 0.02;
    EXPECT_TRUE(alias(f));
}

TEST(ShadowMetrics, LightUnderANearBlockerIsAContactGap) {
    Case c;
    Answers answers;
    int planted = 0;
    for (int y = 10; y < 20; ++y)
        for (int x = 50; x < 60; ++x, ++planted) {
            c.picture[c.at(x, y)] = 1;
            answers.blockerDistance_m[c.at(x, y)] = 0.03f;  // under 4 pixels
        }
    const double share = double(planted) / kCount;
    expectOnly(c.measure(answers.question({})), "contact_gap", share);
    // With fine texels the blocker is far, and the same pixels are a leak.
    TexelFootprint fine;
    fine.texel_m = 0.005;
    expectOnly(c.measure(answers.question(fine)), "leak", share);
    // At the edge, too, it is a contact gap first.
    for (int y = 0; y < kHeight; ++y) {
        c.picture[c.at(kWidth / 2, y)] = 1;
        answers.blockerDistance_m[c.at(kWidth / 2, y)] = 0.001f;
    }
    expectOnly(c.measure(answers.question({})), "contact_gap", share + 1.0 / kWidth);
}

TEST(ShadowMetrics, LightFarInsideTheUmbraIsALeak) {
    Case c;
    for (int y = 0; y < kHeight; ++y) c.picture[c.at(50, y)] = 0.5f;
    const ShadowMeasurement m = c.measure();
    expectOnly(m, "leak", 1.0 / kWidth);
    // The interior begins 5 px beyond the last lit column: columns 36 to 63.
    EXPECT_DOUBLE_EQ(*m.metrics.at("leak_mass"), 0.5 / 28);
    // Half is not wrong yet.
    EXPECT_EQ(*m.metrics.at("wrong"), 0);
}

TEST(ShadowMetrics, TheWidthOfASoftShadowIsPenumbra) {
    // A ramp of 16 pixels in truth, a hard edge in the picture.
    Case c;
    c.truth.soft = true;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 24; x < 40; ++x) {
            c.truth.visibility[c.at(x, y)] = float(40 - x) / 17;
            c.picture[c.at(x, y)] = x < 32 ? 1.0f : 0.0f;
        }
    const ShadowMeasurement m = c.measure();
    EXPECT_GT(*m.metrics.at("penumbra"), 0.2);
    EXPECT_DOUBLE_EQ(*m.metrics.at("penumbra"), *m.metrics.at("over"));
    expectOnly(m, "under_blur", *m.metrics.at("over"));
    // The same in a hard truth's tolerance is smaller, and three standard errors forgive more.
    std::fill(c.truth.standardError.begin(), c.truth.standardError.end(), 1.0f);
    EXPECT_EQ(*c.measure().metrics.at("over"), 0);
}

TEST(ShadowMetrics, TolerancesOfHardAndSoftLights) {
    Case c;
    for (int x = 0; x < 10; ++x) c.picture[c.at(x, 0)] = 0.92f;
    EXPECT_EQ(*c.measure().metrics.at("over"), 0);
    c.truth.soft = true;
    EXPECT_DOUBLE_EQ(*c.measure().metrics.at("over"), 10.0 / kCount);
}

TEST(ShadowMetrics, WrongLeavesTheGrazingBandOut) {
    Case c;
    for (int y = 0; y < kHeight; ++y) {
        c.picture[c.at(0, y)] = c.picture[c.at(1, y)] = 0;
        c.truth.cosine[c.at(0, y)] = 0.01f;
    }
    const Metrics m = c.measure().metrics;
    EXPECT_DOUBLE_EQ(*m.at("wrong"), 1.0 / (kWidth - 1));
    EXPECT_DOUBLE_EQ(*m.at("over"), 2.0 / kWidth);
}

TEST(ShadowMetrics, WrongInTheDomainAndInTheLight) {
    Case c;
    std::vector<bool> inDomain(kCount, true);
    for (int y = 0; y < kHeight; ++y) {
        c.picture[c.at(0, y)] = c.picture[c.at(1, y)] = 0;
        inDomain[c.at(0, y)] = false;
        c.truth.irradiance[c.at(0, y)] = 0;
        c.truth.irradiance[c.at(1, y)] = 3;
    }
    ShadowQuestion question;
    question.inDomain = inDomain;
    const Metrics m = c.measure(question).metrics;
    EXPECT_DOUBLE_EQ(*m.at("wrong"), 2.0 / kWidth);
    EXPECT_DOUBLE_EQ(*m.at("wrong_domain"), 1.0 / (kWidth - 1));
    EXPECT_DOUBLE_EQ(*m.at("wrong_lit"), 3.0 / (kWidth + 1));
    EXPECT_DOUBLE_EQ(*m.at("rmse_lit"), std::sqrt(3.0 / (kWidth + 1)));
    // The range bounds the domain, too.
    question.inRange = inDomain;
    question.inDomain.clear();
    EXPECT_DOUBLE_EQ(*c.measure(question).metrics.at("wrong_domain"), 1.0 / (kWidth - 1));
    question.inDomain.assign(kCount, false);
    EXPECT_FALSE(c.measure(question).metrics.at("wrong_domain"));
}

TEST(ShadowMetrics, ClassesPartitionOver) {
    Case c;
    Answers answers;
    c.truth.soft = true;
    for (std::size_t i = 0; i < kCount; ++i) {
        c.picture[i] = float((i * 7919) % 101) / 100;
        if (i % 5 == 0) c.truth.visibility[i] = 0.5f;
        if (i % 11 == 0) answers.blockerDistance_m[i] = 0.01f;
        if (i % 13 == 0) c.truth.mask[i] = Mask::Disagree;
    }
    ShadowQuestion question = answers.question({});
    for (std::size_t i = 0; i < kCount; ++i) question.inRange.push_back(i % 7 != 0);
    const ShadowMeasurement m = c.measure(question);
    // Exactly: every valid pixel is counted once, and all that are not right are over.
    std::size_t counted = 0;
    for (const std::size_t count : m.classCounts) counted += count;
    EXPECT_EQ(counted, m.validCount);
    const std::size_t right = m.classCounts[std::size_t(ErrorClass::None)];
    EXPECT_DOUBLE_EQ(*m.metrics.at("over"), double(m.validCount - right) / double(m.validCount));
    EXPECT_DOUBLE_EQ(*m.metrics.at("penumbra"), *m.metrics.at("over_blur") + *m.metrics.at("under_blur"));
    double sum = 0;
    for (const auto& key : kClasses) sum += *m.metrics.at(key);
    // 1e-12: the sum of nine shares.
    EXPECT_NEAR(sum, *m.metrics.at("over"), 1e-12);
    EXPECT_GT(sum, 0.5);
    for (std::size_t i = 0; i < kCount; ++i)
        if (c.truth.mask[i] != Mask::Valid) {
            EXPECT_EQ(m.classes[i], ErrorClass::None);
        }
}

TEST(ShadowMetrics, NoValidPixelIsNull) {
    Case c;
    std::fill(c.truth.mask.begin(), c.truth.mask.end(), Mask::Sky);
    const ShadowMeasurement m = c.measure();
    EXPECT_EQ(m.validCount, 0u);
    for (const auto& [key, value] : m.metrics) EXPECT_FALSE(value) << key;
}

TEST(ShadowMetrics, WhatIsNoNumberIsWrong) {
    Case c;
    std::fill(c.picture.begin(), c.picture.end(), std::nanf(""));
    EXPECT_EQ(*c.measure().metrics.at("wrong"), 1);
    EXPECT_EQ(*c.measure().metrics.at("leak_mass"), 1);
}

TEST(ShadowMetrics, DegenerateAnswersAreSeen) {
    Case c;
    std::fill(c.picture.begin(), c.picture.end(), 1.0f);
    EXPECT_DOUBLE_EQ(*c.measure().metrics.at("wrong"), 0.5);
    std::fill(c.picture.begin(), c.picture.end(), 0.0f);
    EXPECT_DOUBLE_EQ(*c.measure().metrics.at("wrong"), 0.5);
    std::fill(c.picture.begin(), c.picture.end(), 0.5f);
    EXPECT_DOUBLE_EQ(*c.measure().metrics.at("over"), 1);
    EXPECT_DOUBLE_EQ(*c.measure().metrics.at("gain_db"), 0);
}

TEST(ShadowMetrics, SizesMustAgree) {
    Case c;
    ShadowQuestion question;
    question.inDomain.resize(3);
    EXPECT_THROW(c.measure(question), Error);
    question.inDomain.clear();
    question.inRange.resize(3);
    EXPECT_THROW(c.measure(question), Error);
    question.inRange.clear();
    const ShadowFeatures features;
    question.features = &features;
    EXPECT_THROW(c.measure(question), Error);
    c.truth.soft = true;
    c.truth.centreSeen.pop_back();
    EXPECT_THROW(c.measure(), Error);
    c.truth.soft = false;
    EXPECT_NO_THROW(c.measure());
    c.picture.pop_back();
    EXPECT_THROW(c.measure(), Error);
}

TEST(ShadowMetrics, EveryKeyIsDocumentedOnce) {
    std::set<std::string> keys;
    for (const MetricInfo& info : metricInfos()) {
        EXPECT_TRUE(keys.insert(info.key).second) << info.key;
        EXPECT_FALSE(info.help.empty()) << info.key;
    }
    for (const auto& [key, value] : Case().measure().metrics) EXPECT_TRUE(keys.count(key)) << key;
    EXPECT_EQ(keys.size(), Case().measure().metrics.size() + 3 + 4) << "all but flip, noise, residual and four of motion";
}

TEST(HardEdges, LieWhereTheShadowEndsAndNotWhereTheSurfaceDoes) {
    Case c;
    auto edges = hardEdges(c.truth, c.receivers);
    for (int x = 0; x < kWidth; ++x) EXPECT_EQ(edges[c.at(x, 9)], x == kWidth / 2 - 1 || x == kWidth / 2) << x;
    // The dark half lies 1 m behind the lit one: no shadow edge.
    for (std::size_t i = 0; i < kCount; ++i)
        if (c.truth.visibility[i] == 0) c.receivers.distance_m[i] = 6;
    edges = hardEdges(c.truth, c.receivers);
    EXPECT_EQ(std::count(edges.begin(), edges.end(), true), 0);
    // A steep floor, 0.2 m a pixel, goes on across the edge.
    for (std::size_t i = 0; i < kCount; ++i) c.receivers.distance_m[i] = 5 + 0.2f * float(i % kWidth);
    edges = hardEdges(c.truth, c.receivers);
    EXPECT_EQ(std::count(edges.begin(), edges.end(), true), 2 * kHeight);
    // Next to pixels that are not measured nothing is known.
    for (int y = 0; y < kHeight; ++y) c.truth.mask[c.at(kWidth / 2, y)] = Mask::Disagree;
    edges = hardEdges(c.truth, c.receivers);
    EXPECT_EQ(std::count(edges.begin(), edges.end(), true), 0);
}

TEST(DistanceTransform, IsExact) {
    // Against all pairs, on scattered marks.
    constexpr int w = 37, h = 23;
    std::vector<bool> marked(w * h, false);
    for (int i = 0; i < 12; ++i) marked[std::size_t((i * 7919 + 13) % (w * h))] = true;
    const auto d = distanceTransform(marked, w, h);
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            double nearest = 1e9;
            for (int j = 0; j < w * h; ++j)
                if (marked[std::size_t(j)]) nearest = std::min(nearest, std::hypot(x - j % w, y - j / w));
            EXPECT_FLOAT_EQ(d[std::size_t(y * w + x)], float(nearest));
        }
    EXPECT_TRUE(std::isinf(distanceTransform(std::vector<bool>(6, false), 3, 2)[0]));
}

}  // namespace
}  // namespace ombrage::test
