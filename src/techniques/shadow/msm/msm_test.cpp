// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "metrics/error_classes.h"
#include "techniques/shadow/msm/quantisation.h"
#include "techniques/technique_case.h"
#include "techniques/two_sheets_scene.h"

namespace ombrage {
namespace {

using test::TwoSheets;

/// From where on a row of pixels is under the box of an edge on both of its sides.
constexpr int kFrom_px = 40, kTo_px = 88;

constexpr double kSqrt3 = 1.7320508075688772;

glm::dvec4 powers(double z) {
    return {z, z * z, z * z * z, z * z * z * z};
}

glm::dvec4 stored(const glm::dvec4& moments) {
    const msm::Quantisation form = msm::quantisation();
    const glm::dvec2 odd(moments[0], moments[2]), even(moments[1], moments[3]);
    return {glm::dot(form.odd[0], odd) + 0.5, glm::dot(form.odd[1], odd) + 0.5, glm::dot(form.even[0], even),
            glm::dot(form.even[1], even)};
}

TEST(MomentQuantisation, MomentsOfDepthsFillTheUnitInterval) {
    glm::dvec4 least(1), most(0);
    for (int i = -1000; i <= 1000; ++i) {
        const glm::dvec4 s = stored(powers(i / 1000.0));
        least = glm::min(least, s);
        most = glm::max(most, s);
    }
    for (int k = 0; k < 4; ++k) {
        // Steps of a thousandth miss an extremum by at most a few millionths; roundings of doubles may pass it.
        EXPECT_NEAR(least[k], 0, 2e-6);
        EXPECT_NEAR(most[k], 1, 2e-6);
        EXPECT_GE(least[k], -1e-15);
        EXPECT_LE(most[k], 1 + 1e-15);
    }
    // By hand: 3/2 * 1/2 - 2 / 8 + 1/2, the extremum of the second, 4/2 - 4/4, and the fourth at the end.
    EXPECT_DOUBLE_EQ(stored(powers(0.5))[0], 1);
    EXPECT_DOUBLE_EQ(stored(powers(kSqrt3 / 2))[1], 1);
    EXPECT_DOUBLE_EQ(stored(powers(std::sqrt(0.5)))[2], 1);
    EXPECT_DOUBLE_EQ(stored(powers(-1))[3], 1);
}

TEST(MomentQuantisation, TheWayBackIsTheInverse) {
    const msm::Quantisation form = msm::quantisation();
    const glm::dmat2 odd = msm::inverseRows(form.odd), even = msm::inverseRows(form.even);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> depth(-1, 1);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec4 moments = 0.5 * powers(depth(random)) + 0.5 * powers(depth(random)), s = stored(moments);
        const glm::dvec2 fromOdd(s.x - 0.5, s.y - 0.5), fromEven(s.z, s.w);
        // A few roundings of doubles.
        EXPECT_NEAR(glm::dot(odd[0], fromOdd), moments[0], 1e-14);
        EXPECT_NEAR(glm::dot(odd[1], fromOdd), moments[2], 1e-14);
        EXPECT_NEAR(glm::dot(even[0], fromEven), moments[1], 1e-14);
        EXPECT_NEAR(glm::dot(even[1], fromEven), moments[3], 1e-14);
    }
}

/// Coefficients (cos a, sin a) of two powers, scaled so that the polynomial's range over [-1,1] has the length 1.
glm::dvec2 scaledToUnit(double angle_rad, bool odd) {
    const glm::dvec2 c(std::cos(angle_rad), std::sin(angle_rad));
    double least = 0, most = 0;
    for (int i = -500; i <= 500; ++i) {
        const glm::dvec4 p = powers(i / 500.0);
        const double value = odd ? c.x * p[0] + c.y * p[2] : c.x * p[1] + c.y * p[3];
        least = std::min(least, value);
        most = std::max(most, value);
    }
    return c / (most - least);
}

double determinant(const glm::dvec2& a, const glm::dvec2& b) {
    return std::abs(a.x * b.y - a.y * b.x);
}

TEST(MomentQuantisation, NoOtherPairOfPolynomialsSpansMore) {
    const msm::Quantisation form = msm::quantisation();
    for (const bool odd : {true, false}) {
        const double ours = odd ? determinant(form.odd[0], form.odd[1]) : determinant(form.even[0], form.even[1]);
        constexpr int kAngles = 720;
        std::vector<glm::dvec2> all;
        for (int i = 0; i < kAngles; ++i) all.push_back(scaledToUnit(i * 3.14159265358979 / kAngles, odd));
        double best = 0;
        for (const glm::dvec2& a : all)
            for (const glm::dvec2& b : all) best = std::max(best, determinant(a, b));
        // Ranges are found a little too small between 1000 steps; the best pair lies between directions a quarter of a
        // degree apart.
        EXPECT_LT(best, ours * 1.0001) << odd;
        EXPECT_GT(best, ours * 0.97) << odd;
    }
}

/// Depths and their shares.
struct Depth {
    double z, share;
};

template <typename F>
double expectation(const std::array<Depth, 3>& depths, F of) {
    double sum = 0;
    for (const Depth& d : depths) sum += d.share * of(d.z);
    return sum;
}

/// Three depths beyond all of which z0 lies: with the polynomials that are 1 at one of them and 0 at the others, the
/// largest share that any distribution with their moments can have at z0 is 1 / sum of L_i(z0)^2 / share_i.
double largestShareBeyond(const std::array<Depth, 3>& depths, double z0) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double a = depths[(i + 1) % 3].z, b = depths[(i + 2) % 3].z, z = depths[i].z;
        const double polynomial = (z0 - a) * (z0 - b) / ((z - a) * (z - b));
        sum += polynomial * polynomial / std::max(depths[i].share, 1e-12);
    }
    return 1 / sum;
}

/// Hausdorff's bound where z0 and both ends of the range take part: the free depth makes the expectation of the
/// polynomial vanish that has all four as roots, and what is lit are the shares that lie at z0 or beyond.
double litBetweenEnds(const std::array<Depth, 3>& depths, double z0) {
    const auto weighted = [&](double z) { return (1 - z * z) * (z - z0); };
    const double y = expectation(depths, [&](double z) { return z * weighted(z); }) / expectation(depths, weighted);
    EXPECT_LE(std::abs(y), 1);
    const std::array<double, 4> nodes = {-1, z0, y, 1};
    double lit = 0;
    for (std::size_t i = 1; i < 4; ++i) {
        if (nodes[i] < z0) continue;
        lit += expectation(depths, [&](double z) {
            double product = 1;
            for (std::size_t j = 0; j < 4; ++j)
                if (j != i) product *= (z - nodes[j]) / (nodes[i] - nodes[j]);
            return product;
        });
    }
    return lit;
}

/// TwoSheets' upper sheet for x < 0, one at `middle_m` that ends at x = 6 m and one at `lower_m` under everything.
struct ThreeSheets {
    TwoSheets scene{false};
    double middle_m, lower_m;

    ThreeSheets(float middleAt_m, float lowerAt_m) : middle_m(middleAt_m), lower_m(lowerAt_m) {
        scene.addLevel(middleAt_m, -TwoSheets::kHalf_m, 6, TwoSheets::kHalf_m);
        if (lowerAt_m > 0) scene.addLevel(lowerAt_m, -TwoSheets::kHalf_m, TwoSheets::kHalf_m, TwoSheets::kHalf_m);
        scene.scene.cameras[0].position.z = 1;
    }

    std::array<Depth, 3> depths(int pixel) const {
        const double upper = 1 - TwoSheets::freeShare(pixel);
        const double lower = std::clamp(TwoSheets::freeShare(pixel) - 6 / 31.0, 0.0, 1.0);
        return {{{TwoSheets::depthOf(20), upper},
                 {TwoSheets::depthOf(middle_m), 1 - upper - lower},
                 {TwoSheets::depthOf(lower_m), lower}}};
    }
};

std::string plain(const std::string& more) {
    return TwoSheets::plain("shadow/msm", more);
}

TEST(MomentShadowMap, OneDepthIsAStep) {
    for (const char* more :
         {",bits=32f", ",bits=16", ",bits=32f,reconstruction=hausdorff", ",bits=16,reconstruction=hausdorff"}) {
        const std::vector<float> row = TwoSheets(false).row(plain(more));
        // Up to a step of a 16-bit float below 1.
        for (std::size_t i = 80; i < kTo_px; ++i) EXPECT_NEAR(row[i], 1, 5e-4f) << more << i;
        // What the moment bias of 16 bits leaves: 6e-5 over the deviation that it mixes in.
        for (std::size_t i = kFrom_px; i < 48; ++i) EXPECT_LT(row[i], 1e-3f) << more << i;
    }
}

TEST(MomentShadowMap, TwoDepthsAreExact) {
    for (const char* more :
         {",bits=32f", ",bits=16", ",bits=32f,reconstruction=hausdorff", ",bits=16,reconstruction=hausdorff"}) {
        const bool coarse = std::string(more).find("16") != std::string::npos;
        const std::vector<float> lit = TwoSheets(false).row(plain(more)), dark = TwoSheets(true).row(plain(more));
        for (int i = kFrom_px; i < kTo_px; ++i) {
            // The corner that the lookup between texels rounds (an eighth of a texel), and the moment bias, whose
            // effect at depths in front of the floor goes with its square root.
            EXPECT_NEAR(lit[std::size_t(i)], TwoSheets::freeShare(i), 0.125 / 31 + (coarse ? 0.02 : 2e-3)) << more << i;
            EXPECT_LT(dark[std::size_t(i)], coarse ? 2e-3 : 2e-5) << more << i;
        }
    }
}

TEST(MomentShadowMap, ThreeDepthsLeakByTheBoundOfTheirMoments) {
    const ThreeSheets sheets(11, 2);
    const double floor = TwoSheets::depthOf(0);
    for (const char* more : {",bits=32f", ",bits=16", ",bits=32f,reconstruction=hausdorff"}) {
        const bool coarse = std::string(more).find("16") != std::string::npos;
        const std::vector<float> row = sheets.scene.row(plain(more));
        // Where all three have shares of a tenth and more.
        for (int i = 54; i < 76; ++i) {
            if (sheets.depths(i)[0].share < 0.1 || sheets.depths(i)[2].share < 0.1) continue;
            const double expected = largestShareBeyond(sheets.depths(i), floor);
            EXPECT_NEAR(row[std::size_t(i)], expected, coarse ? 5e-3 : 1e-3) << more << i;
            EXPECT_GT(expected, 0.05) << "the truth is dark";
        }
    }
    // By hand for equal shares at 0, 9 and 18 of 20 m: L = 11*2/162, 20*2/-81, 20*11/162; 3 (0.0184 + 0.2439 + 1.8442)
    // = 6.3195.
    const auto z = [](double height_m) { return TwoSheets::depthOf(height_m); };
    EXPECT_NEAR(largestShareBeyond({{{z(20), 1 / 3.0}, {z(11), 1 / 3.0}, {z(2), 1 / 3.0}}}, floor), 1 / 6.3195, 1e-5);
}

TEST(MomentShadowMap, HausdorffKnowsTheEndsOfTheRange) {
    // The floor is raised by bias to 14 m, between the upper sheet and the middle one: Hamburger's third depth lies
    // outside.
    const ThreeSheets sheets(11, 0);
    const double z0 = TwoSheets::depthOf(14 * 1.002);
    const auto raised = [&](const std::string& more) {
        std::string technique = plain(",bits=32f" + more);
        technique.replace(technique.find("constant-bias=0"), 15, "constant-bias=14");
        return sheets.scene.row(technique);
    };
    const std::vector<float> hamburger = raised(""), hausdorff = raised(",reconstruction=hausdorff");
    int differ = 0;
    for (int i = 54; i < 76; ++i) {
        const auto depths = sheets.depths(i);
        if (depths[0].share < 0.1 || depths[2].share < 0.1) continue;
        const float ends = hausdorff[std::size_t(i)], any = hamburger[std::size_t(i)];
        // Both are bounds of what is truly at 14 m or below, and that which knows more is nearer to it.
        EXPECT_GE(ends, 1 - depths[0].share - 2e-3) << i;
        EXPECT_LE(ends, any + 1e-5) << i;
        if (ends > any - 1e-3) continue;
        ++differ;
        EXPECT_NEAR(ends, litBetweenEnds(depths, z0), 2e-3) << i;
    }
    EXPECT_GT(differ, 3);
}

TEST(MomentShadowMap, LeaksLessThanVarianceUnderTwoCasters) {
    const TwoSheets sheets(true);
    const auto total = [&](const std::string& technique) {
        double sum = 0;
        const std::vector<float> row = sheets.row(technique);
        for (std::size_t i = kFrom_px; i < kTo_px; ++i) sum += double(row[i]);
        return sum;
    };
    const double variance = total(TwoSheets::plain("shadow/vsm", ",bits=32f"));
    EXPECT_GT(variance, 1);
    EXPECT_LT(total(plain(",bits=16")), 0.25 * variance);
}

Metrics measuredOn(const std::string& scene, const std::string& technique) {
    test::Bench& bench = test::Bench::of(scene);
    RenderSettings settings;
    settings.width = test::kWidth;
    settings.height = test::kHeight;
    settings.light = "lamp";
    settings.shadow = parsePipeline(Family::Shadow, technique);
    const RenderResult result = test::renderScene(bench.scene(), settings);
    ShadowQuestion question;
    question.features = &bench.features("", "lamp");
    question.footprint = result.footprint.begin()->second;
    return measureShadow(test::measuredPlane(result, Family::Shadow), bench.shadow("", "lamp", 0), bench.receivers(""),
                         question)
        .metrics;
}

// Two casters and a floor are what four moments can tell apart, three are not: with a wide filter light comes through.
TEST(MomentShadowMap, LeaksUnderThreeCastersButNotUnderTwo) {
    const Metrics two = measuredOn("two-casters", "shadow/msm:kernel=31"),
                  three = measuredOn("three-casters", "shadow/msm:kernel=31"),
                  variance = measuredOn("two-casters", "shadow/vsm:kernel=31,bleeding=0");
    EXPECT_GT(*variance.at("leak"), 0.001);
    // Two or three pixels, where a slab's side is a third depth.
    EXPECT_LT(*two.at("leak"), 4e-5);
    EXPECT_GT(*three.at("leak"), 8e-5);
    EXPECT_LT(*two.at("leak_mass"), 0.25 * *variance.at("leak_mass"));
}

}  // namespace
}  // namespace ombrage
