// SPDX-License-Identifier: MIT
// What decides between classes that a picture alone cannot tell apart, and the figures that stand beside them.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <ombrage/error.h>

#include "metrics/error_classes.h"
#include "metrics/error_colors.h"
#include "metrics/planted_case.h"
#include "metrics/shadow_edges.h"

namespace ombrage::test {
namespace {

ErrorClass classAt(const Case& c, const ShadowQuestion& question, int x, int y) {
    return c.measure(question).classes[Case::at(x, y)];
}

TEST(ErrorClasses, DarkPixelsInTheLightAreAcneOnlyWhereTheirSurfaceCanShadeThem) {
    Case c;
    c.picture[Case::at(5, 5)] = 0;
    Answers answers;
    answers.around = {true, false, true};
    EXPECT_EQ(classAt(c, answers.question(kFineTexels), 5, 5), ErrorClass::Acne);
    // A surface that casts no shadow is in no depth map.
    answers.around.ownCasts = false;
    EXPECT_EQ(classAt(c, answers.question(kFineTexels), 5, 5), ErrorClass::FalseShadow);
    // A caster beside the light's ray: its edge is as coarse as the texels, wherever it falls.
    answers.around = {true, true, true};
    EXPECT_EQ(classAt(c, answers.question(kFineTexels), 5, 5), ErrorClass::Alias);
    // Under a light with a size its edge is a penumbra, which ends elsewhere.
    c.truth.soft = true;
    EXPECT_EQ(classAt(c, answers.question(kFineTexels), 5, 5), ErrorClass::FalseShadow);
    // Techniques without texels compare no depths beside the point.
    answers.asked.clear();
    EXPECT_EQ(classAt(c, answers.question({}), 5, 5), ErrorClass::FalseShadow);
    EXPECT_TRUE(answers.asked.empty());
}

TEST(ErrorClasses, LightInTheUmbraIsALeakUnlessAnEdgePassesBesideIt) {
    Case c;
    c.picture[Case::at(60, 5)] = 1;
    Answers answers;
    answers.around = {false, true, true};
    EXPECT_EQ(classAt(c, answers.question(kFineTexels), 60, 5), ErrorClass::Leak);
    answers.around.lit = true;
    EXPECT_EQ(classAt(c, answers.question(kFineTexels), 60, 5), ErrorClass::Alias);
    EXPECT_EQ(answers.asked, std::vector<std::uint32_t>{std::uint32_t(Case::at(60, 5))});
    EXPECT_EQ(classAt(c, answers.question({}), 60, 5), ErrorClass::Leak) << "without texels";
}

TEST(ErrorClasses, LeaksUnderSeveralBlockersAreCounted) {
    Case c;
    c.picture[Case::at(60, 5)] = 1;
    Answers answers;
    EXPECT_EQ(*c.measure(answers.question({})).metrics.at("leak_layered"), 0);
    answers.layers = 2;
    EXPECT_DOUBLE_EQ(*c.measure(answers.question({})).metrics.at("leak_layered"), 1.0 / kCount);
    EXPECT_FALSE(c.measure().metrics.at("leak_layered")) << "not known without features";
}

TEST(ErrorClasses, OutsideTheRangeIsMissingBeforeAnythingElse) {
    Case c;
    Answers answers;
    for (int y = 0; y < kHeight; ++y)
        for (int x = kWidth / 2; x < kWidth; ++x) c.picture[Case::at(x, y)] = 1;
    answers.blockerDistance_m.assign(kCount, 0.001f);
    ShadowQuestion question = answers.question({});
    question.inRange.assign(kCount, true);
    for (int y = 0; y < kHeight / 2; ++y)
        for (int x = 0; x < kWidth; ++x) question.inRange[Case::at(x, y)] = false;
    const Metrics m = c.measure(question).metrics;
    EXPECT_DOUBLE_EQ(*m.at("missing"), 0.25) << "right pixels outside the range are not missed";
    EXPECT_DOUBLE_EQ(*m.at("contact_gap"), 0.25);
    EXPECT_EQ(answers.askedBlockers.size(), kCount / 4) << "what is missing needs no blocker";
}

TEST(ErrorClasses, OnlyPixelsThatAreTooLightAskForTheirBlockers) {
    Case c;
    Answers answers;
    answers.blockerDistance_m.assign(kCount, 0.001f);
    // Right and wrong, masked and dark pixels in the shadow, and a dark one in the light.
    c.picture[Case::at(60, 5)] = 1;
    c.picture[Case::at(60, 6)] = 1;
    c.picture[Case::at(60, 7)] = 0.05f;
    c.picture[Case::at(5, 5)] = 0;
    c.truth.mask[Case::at(60, 6)] = Mask::Disagree;
    const ShadowMeasurement m = c.measure(answers.question({}));
    EXPECT_EQ(answers.askedBlockers, std::vector<std::uint32_t>{std::uint32_t(Case::at(60, 5))});
    EXPECT_EQ(m.classes[Case::at(60, 5)], ErrorClass::ContactGap);
    EXPECT_EQ(m.classes[Case::at(5, 5)], ErrorClass::FalseShadow);
    EXPECT_EQ(c.measure().classes[Case::at(60, 5)], ErrorClass::Leak) << "not known without features";
}

TEST(ErrorClasses, WhatIsBrighterThanLitIsOther) {
    Case c;
    c.picture[Case::at(5, 5)] = 1.5f;
    c.picture[Case::at(60, 5)] = -0.5f;
    EXPECT_DOUBLE_EQ(*c.measure().metrics.at("other"), 2.0 / kCount);
}

/// A soft shadow: a ramp `width` pixels wide about the middle, and the hard shadow that its light's centre throws.
Case ramp(double width) {
    Case c;
    c.truth.soft = true;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            c.truth.visibility[Case::at(x, y)] = float(std::clamp((kWidth / 2 - 0.5 - x) / width + 0.5, 0.0, 1.0));
    c.picture = c.truth.visibility;
    return c;
}

TEST(ErrorClasses, ATransitionThatIsTooWideIsOverBlur) {
    Case c = ramp(12);
    const Case wide = ramp(20);
    c.picture = wide.truth.visibility;
    const Metrics m = c.measure().metrics;
    EXPECT_GT(*m.at("over_blur"), 0.1);
    EXPECT_EQ(*m.at("under_blur"), 0);
    // It errs outside the true penumbra as well, and is over-blur there: 4 px on either side.
    EXPECT_DOUBLE_EQ(*m.at("over"), *m.at("over_blur"));

    c.picture = ramp(6).truth.visibility;
    EXPECT_GT(*c.measure().metrics.at("under_blur"), 0.05);
    EXPECT_EQ(*c.measure().metrics.at("over_blur"), 0);
    // A hard edge in another place is not too wide.
    for (std::size_t i = 0; i < kCount; ++i) c.picture[i] = i % kWidth < 24 ? 1.0f : 0.0f;
    EXPECT_GT(*c.measure().metrics.at("under_blur"), 0.1);
    EXPECT_EQ(*c.measure().metrics.at("over_blur"), 0);
}

TEST(PenumbraMetrics, AreThoseOfThePenumbraAlone) {
    Case c = ramp(12);
    EXPECT_EQ(*c.measure().metrics.at("rmse_penumbra"), 0);
    EXPECT_EQ(*c.measure().metrics.at("hard_ratio"), 0);
    // The plain hard shadow is the measure of itself.
    c.picture = hardShadow(c.truth);
    EXPECT_DOUBLE_EQ(*c.measure().metrics.at("hard_ratio"), 1);
    // Of a ramp from 0 to 1 it errs by 0 to a half: a root mean square of 1/sqrt(12) over the ramp, 0 over 4 px on
    // either side, whose first pixel is the ramp's last. 2 %: 12 steps for an integral.
    EXPECT_NEAR(*c.measure().metrics.at("rmse_penumbra"), std::sqrt(12.0 / (12 * 20)), 0.02 * 0.22);
    // Errors elsewhere do not count, and hard lights have no penumbra.
    c.picture = c.truth.visibility;
    for (int y = 0; y < kHeight; ++y) c.picture[Case::at(2, y)] = 0;
    EXPECT_EQ(*c.measure().metrics.at("rmse_penumbra"), 0);
    c.truth.soft = false;
    EXPECT_FALSE(c.measure().metrics.at("rmse_penumbra"));
    EXPECT_FALSE(c.measure().metrics.at("hard_ratio"));
}

/// Light on the side of a straight edge at an angle, `shift_px` away from the middle.
std::vector<float> slanted(double angle_rad, double shift_px) {
    std::vector<float> v(kCount);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const double along =
                (x - 0.5 * kWidth + 0.37) * std::cos(angle_rad) + (y - 0.5 * kHeight + 0.19) * std::sin(angle_rad);
            v[Case::at(x, y)] = along < shift_px ? 1.0f : 0.0f;
        }
    return v;
}

TEST(EdgeDisplacement, IsThatOfAShiftedEdgeAtAnyAngle) {
    TexelFootprint footprint;
    footprint.texel_m = 0.05;  // 5 pixels, so that shifts of 3 stay within the reach of alias
    for (const double angle_deg : {0.0, 17.0, 40.0, 63.0, 90.0, 121.0}) {
        const double angle = angle_deg * 0.017453292519943295;
        Case c;
        c.truth.visibility = slanted(angle, 0);
        for (const double shift_px : {-2.0, 1.0, 3.0}) {
            c.picture = slanted(angle, shift_px);
            // 8 %: a slanted edge of pixels has steps, and ends at the picture's border. (At 45 degrees it can only
            // move by 0.7 pixels.)
            EXPECT_NEAR(*c.measure(withTexels(footprint)).metrics.at("edge_px"), std::abs(shift_px),
                        0.08 * std::abs(shift_px))
                << angle_deg << " degrees";
        }
    }
    // A blur on both sides alike does not move the edge.
    Case c;
    for (int y = 0; y < kHeight; ++y) {
        c.picture[Case::at(kWidth / 2 - 1, y)] = 0.7f;
        c.picture[Case::at(kWidth / 2, y)] = 0.3f;
    }
    EXPECT_EQ(*c.measure().metrics.at("edge_px"), 0);
    // Without an edge there is no displacement.
    EXPECT_FALSE(Case(kWidth).measure().metrics.at("edge_px"));
}

TEST(Terminator, CountsWhatShadingAndGeometryDisagreeAbout) {
    Case c;
    Answers answers;
    for (int x = 0; x < kWidth; ++x) {
        c.truth.cosine[Case::at(x, 0)] = -0.01f;
        c.truth.mask[Case::at(x, 0)] = Mask::BelowHorizon;
        c.truth.mask[Case::at(x, 1)] = Mask::Sky;
    }
    for (int x = 0; x < kWidth / 2; ++x) answers.features.shadingCosine[Case::at(x, 0)] = -0.01f;
    EXPECT_DOUBLE_EQ(*c.measure(answers.question({})).metrics.at("terminator"), 0.5 / (kHeight - 1));
    EXPECT_FALSE(c.measure().metrics.at("terminator")) << "not known without features";
}

TEST(Noise, IsTheDeviationAmongSeeds) {
    const std::vector<Mask> mask{Mask::Valid, Mask::Valid, Mask::Sky};
    // The first pixel varies by +-1 about 1 (variance 2 of two values), the second not at all, the third is not
    // measured.
    EXPECT_DOUBLE_EQ(*noiseOf({{0, 0.5f, 9}, {2, 0.5f, 0}}, mask), 1);
    EXPECT_EQ(*noiseOf({{1, 2, 3}, {1, 2, 3}}, mask), 0);
    EXPECT_FALSE(noiseOf({{1}, {2}}, {Mask::Sky}));
    EXPECT_THROW(noiseOf({{1, 2, 3}}, mask), Error);
    EXPECT_THROW(noiseOf({{1, 2, 3}, {1, 2}}, mask), Error);
}

TEST(Range, IsWhatItsViewsAndItsDistanceCover) {
    Camera camera;
    camera.position = {0, 0, 5};
    camera.target = {0, 0, 0};
    const std::vector<glm::dvec3> positions{{0, 0, 0}, {3, 0, 0}, {0, 0, -20}, {30, 0, 0}};
    EXPECT_EQ(inRange({}, positions, camera), std::vector<bool>(4, true));
    // Two views of 2 m, about 0 and about x = 3.
    ShadowRange range;
    range.clipFromWorld = {glm::dmat4(1.0), glm::dmat4(1.0)};
    range.clipFromWorld[1][3] = {-3, 0, 0, 1};
    EXPECT_EQ(inRange(range, positions, camera), (std::vector<bool>{true, true, true, false}));
    range.farthest_m = 10;
    EXPECT_EQ(inRange(range, positions, camera), (std::vector<bool>{true, true, false, false}));
    // Behind a perspective view nothing is covered.
    range.clipFromWorld = {-glm::dmat4(1.0)};
    EXPECT_EQ(inRange(range, positions, camera), std::vector<bool>(4, false));
}

/// Linear colour as a person without one kind of cone sees it, or anyone (Machado et al. 2009, severity 1).
glm::dvec3 seenBy(int person, const glm::dvec3& c) {
    static const glm::dmat3 kSight[4] = {glm::dmat3(1.0),
                                         glm::transpose(glm::dmat3(0.152286, 1.052583, -0.204868, 0.114503, 0.786281,
                                                                   0.099216, -0.003882, -0.048116, 1.051998)),
                                         glm::transpose(glm::dmat3(0.367322, 0.860646, -0.227968, 0.280085, 0.672501,
                                                                   0.047413, -0.011820, 0.042940, 0.968881)),
                                         glm::transpose(glm::dmat3(1.255528, -0.076749, -0.178779, -0.078411, 0.930809,
                                                                   0.147602, 0.004733, 0.691367, 0.303900))};
    return glm::clamp(kSight[person] * c, 0.0, 1.0);
}

/// CIE L*a*b*, white D65.
glm::dvec3 lab(const glm::dvec3& linear) {
    const glm::dvec3 xyz(glm::dot(linear, glm::dvec3(0.4124564, 0.3575761, 0.1804375)) / 0.95047,
                         glm::dot(linear, glm::dvec3(0.2126729, 0.7151522, 0.0721750)),
                         glm::dot(linear, glm::dvec3(0.0193339, 0.1191920, 0.9503041)) / 1.08883);
    glm::dvec3 f;
    for (int i = 0; i < 3; ++i) f[i] = xyz[i] > 216.0 / 24389 ? std::cbrt(xyz[i]) : (24389.0 / 27 * xyz[i] + 16) / 116;
    return {116 * f.y - 16, 500 * (f.x - f.y), 200 * (f.y - f.z)};
}

TEST(ErrorColors, AreToldApartByEveryone) {
    std::vector<glm::dvec3> colors{glm::dvec3(double(kMaskedGrey)),
                                   {double(kRightAndLit[0]), double(kRightAndLit[1]), double(kRightAndLit[2])}};
    for (const auto& c : kErrorClassColors) colors.emplace_back(double(c[0]), double(c[1]), double(c[2]));
    for (glm::dvec3& c : colors)
        for (int i = 0; i < 3; ++i) c[i] = c[i] <= 0.04045 ? c[i] / 12.92 : std::pow((c[i] + 0.055) / 1.055, 2.4);
    for (int person = 0; person < 4; ++person)
        for (std::size_t a = 0; a < colors.size(); ++a)
            for (std::size_t b = 0; b < a; ++b)
                // 10 units are some four just noticeable differences.
                EXPECT_GT(glm::distance(lab(seenBy(person, colors[a])), lab(seenBy(person, colors[b]))), 10)
                    << "colours " << a << " and " << b << ", sight " << person;
}

TEST(ErrorClassKeys, AreMetrics) {
    for (std::size_t c = 1; c < kErrorClassCount; ++c) {
        const std::string key = errorClassKey(ErrorClass(c));
        EXPECT_TRUE(std::any_of(metricInfos().begin(), metricInfos().end(), [&](const MetricInfo& info) {
            return info.key == key;
        })) << key;
    }
}

}  // namespace
}  // namespace ombrage::test
