// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <gtest/gtest.h>

#include "techniques/filter_scenes.h"

namespace ombrage::test {
namespace {

constexpr int kSize_px = kFilterPicture_px;
/// One ray a pixel: 1 with the probability that the light is seen, else 0, anew in every frame.
const std::string kOneRay = "shadow/ray-traced:samples=1,pattern=random";

/// A floor under a sun that is `angle_deg` wide, and 100 m over it what stands between: casters are added by the
/// caller.
Scene floorUnderSun(double angle_deg) {
    Scene scene = emptyScene(kSize_px);
    addQuad(scene, {{-400, -400, 0}, {400, -400, 0}, {400, 400, 0}, {-400, 400, 0}}, 0.1f);
    Light sun;
    sun.name = "sun";
    sun.type = LightType::Sun;
    sun.direction = {0, 0, -1};
    sun.angle_rad = glm::radians(angle_deg);
    scene.lights = {sun};
    return scene;
}

void addSheet(Scene& scene, float left, float right) {
    addQuad(scene, {{left, -400, 100}, {right, -400, 100}, {right, 400, 100}, {left, 400, 100}}, 0.1f);
}

/// Bars that leave a share of the sky open, so fine beside the sun (17 m wide up there) that every point sees that
/// share of it: the same noise everywhere, of variance share (1 - share).
Scene floorUnderBars(float share) {
    Scene scene = floorUnderSun(10);
    for (float x = -150; x < 150; x += 1) addSheet(scene, x, x + 1 - share);
    return scene;
}

RenderSettings filteredBy(const std::string& filter) {
    RenderSettings settings = squareSettings(kSize_px);
    settings.shadow = parsePipeline(Family::Shadow, kOneRay + "+" + filter);
    settings.light = "sun";
    settings.show = {"svgf-variance"};
    return settings;
}

/// Mean and standard deviation of the pixels 3 and more from the picture's border.
struct Spread {
    double mean = 0, deviation = 0;
    explicit Spread(const Image& image) {
        std::vector<double> values;
        for (int y = 3; y < kSize_px - 3; ++y)
            for (int x = 3; x < kSize_px - 3; ++x)
                values.push_back(double(image.plane(0)[std::size_t(y * kSize_px + x)]));
        mean = std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
        for (const double v : values) deviation += (v - mean) * (v - mean) / double(values.size());
        deviation = std::sqrt(deviation);
    }
};

/// What is shown as svgf-variance is four times it.
double varianceShown(const RenderResult& result) {
    return Spread(result.shownRaw.at("svgf-variance")).mean / 4;
}

TEST(Svgf, ItKnowsTheNoiseOfAPlaneAndKeepsItsMean) {
    constexpr double kShare = 0.25, kVariance = kShare * (1 - kShare);
    const Scene scene = floorUnderBars(float(kShare));
    const RenderResult plain = renderFlat(scene, filteredBy("filter/svgf"));
    const Spread filtered(plain.visibility.begin()->second);
    // Values of 8100 pixels, each with a ninth of the variance by its history: 0.0016 off; the bars' share 0.001.
    EXPECT_NEAR(filtered.mean, kShare, 0.008);
    EXPECT_LT(filtered.deviation, 0.1 * std::sqrt(kVariance));
    // A weighted mean whose weights' squares sum to s finds 1 - s of the variance: s is a / (2 - a) for one that
    // forgets, and 1/33 for the plain mean of 33 frames. A pixel's estimate is off by 0.06, the mean of 8100 by less
    // than 0.001.
    EXPECT_NEAR(varianceShown(plain), kVariance * (1 - 0.2 / 1.8), 0.004);
    EXPECT_NEAR(varianceShown(renderFlat(scene, filteredBy("filter/svgf:moments-alpha=0"))), kVariance * 32 / 33,
                0.004);
    // Of the mean over frames: what its weights leave.
    EXPECT_NEAR(varianceShown(renderFlat(scene, filteredBy("filter/svgf:guide=mean,alpha=0.1,moments-alpha=0"))),
                kVariance * 32 / 33 * 0.1 / 1.9, 0.0004);
}

TEST(Svgf, WhereThereIsNoHistoryThePictureIsAsked) {
    // The camera leaps aside: nothing that it sees was seen before. Of a half, for asking values draws what is rarer
    // towards what is not (of a quarter the mean would be 0.205).
    const Scene scene = floorUnderBars(0.5f);
    const auto afterLeap = [&](const std::string& filter) {
        Renderer renderer;
        Scene moved = scene;
        renderer.setScene(moved);
        RenderSettings settings = filteredBy(filter);
        if (filter != "filter/svgf") settings.show.clear();
        moved.cameras[0].position.x = moved.cameras[0].target.x = -60;
        renderer.moveScene(moved);
        renderer.render(settings);
        moved.cameras[0].position.x = moved.cameras[0].target.x = 60;
        renderer.moveScene(moved);
        return renderer.render(settings);
    };
    const RenderResult result = afterLeap("filter/svgf");
    // 49 equal weights find 48/49 of the variance; as their estimates overlap, their mean is that of 165, each off by
    // 0.005, but for the share of one half, off by 0.0055, whose square hardly matters.
    EXPECT_NEAR(varianceShown(result), 0.25 * 48 / 49, 0.002);
    const Spread filtered(result.visibility.begin()->second);
    EXPECT_NEAR(filtered.mean, 0.5, 0.017);  // three deviations of the mean of 8100 pixels
    // One frame alone, in which filter/temporal has nothing to go by. Five levels of the spline alone would leave
    // 0.008.
    EXPECT_LT(filtered.deviation, 0.05);
    EXPECT_GT(Spread(afterLeap("filter/temporal").visibility.begin()->second).deviation, 0.49);
}

TEST(Svgf, AnEdgeWithoutNoiseStays) {
    const Scene scene = lightThroughHole(0, 60, -60, 60);
    const std::vector<float> raw = filteredShadow(scene, "filter/none");
    // The first three frames know no better than the picture around, and blur; without feedback nothing of it is left.
    EXPECT_EQ(filteredShadow(scene, "filter/svgf:feedback=false"), raw);
    // With it 0.8^28 of what three frames of five had is.
    const std::vector<float> fed = filteredShadow(scene, "filter/svgf");
    for (std::size_t i = 0; i < raw.size(); ++i) ASSERT_NEAR(fed[i], raw[i], 0.6 * std::pow(0.8, 28) + 0.0005) << i;
    // Nothing bleeds over a step of the geometry either, however noisy it is there.
    const std::string occlusion = "ao/blocks:rotation=hash+filter/svgf";
    EXPECT_EQ(darkestOnQuad(aoOf(quadBeforeRibs(), occlusion)), 1.0f);
    EXPECT_LT(darkestOnQuad(aoOf(quadBeforeRibs(), occlusion + ":sigma-z=1000,sigma-n=0,sigma-l=64")), 0.98f);
}

TEST(Svgf, AStillViewConvergesToThePenumbra) {
    // One straight edge before the sun's disk: the share of a disk beyond a chord.
    Scene scene = floorUnderSun(10);
    addSheet(scene, -400, 0);
    const double radius_m = 100 * std::tan(glm::radians(5.0));
    std::vector<float> truth(std::size_t(kSize_px * kSize_px));
    for (int i = 0; i < kSize_px * kSize_px; ++i) {
        const double c = std::clamp((i % kSize_px + 0.5 - kSize_px / 2) / radius_m, -1.0, 1.0);
        truth[std::size_t(i)] = float(1 - (std::acos(c) - c * std::sqrt(1 - c * c)) / std::numbers::pi);
    }
    const auto error = [&](const std::string& filter) {
        RenderSettings settings = filteredBy(filter);
        settings.show.clear();
        const RenderResult result = renderFlat(scene, settings);
        const auto plane = result.visibility.begin()->second.plane(0);
        return rmseBetween({plane.begin(), plane.end()}, truth);
    };
    // The plain mean of 33 frames has the noise of one over root 33, estimated from the 1600 pixels of the penumbra,
    // good to a twentieth; filtered over the picture it has far less (measured 0.16 of it), and not so much less where
    // the paper's guide is not followed, which leaves penumbrae sharper (0.27).
    const double gathered = error("filter/none") / std::sqrt(33.0);
    EXPECT_NEAR(error("filter/svgf:alpha=0,sigma-l=0"), gathered, 0.1 * gathered);
    EXPECT_LT(error("filter/svgf"), 0.25 * gathered);
    EXPECT_LT(error("filter/svgf:alpha=0,feedback=false,guide=mean"), 0.4 * gathered);
}

TEST(Svgf, WhatMovedAwayFadesByTheShareOfEveryFrame) {
    const auto ghosts = ghostsOfPatch("filter/svgf:sigma-l=0", 12);
    for (std::size_t n = 0; n < ghosts.size(); ++n)
        EXPECT_NEAR(ghosts[n], std::pow(0.8, double(n + 1)), 0.0005) << n;  // half floats
    // What is around is dark, so filtering over the picture takes more of it away.
    for (const char* filter : {"filter/svgf", "filter/svgf:levels=1", "filter/svgf:feedback=false,guide=mean"}) {
        const auto blurred = ghostsOfPatch(filter, 12);
        for (std::size_t n = 0; n < ghosts.size(); ++n)
            EXPECT_LE(blurred[n], std::pow(0.8, double(n + 1)) + 0.0005) << filter << " " << n;
    }
}

TEST(Svgf, WhatWasHiddenTakesNothingFromWhatHidIt) {
    const std::string still = "ao/blocks:rotation=none";
    const auto raw = uncoveredByQuad(still);
    EXPECT_EQ(uncoveredByQuad(still + "+filter/svgf:sigma-l=0"), raw);
    // With every depth taken for the same surface the quad's history stays behind.
    EXPECT_GT(rmseBetween(uncoveredByQuad(still + "+filter/svgf:sigma-l=0,depth-tolerance=1"), raw), 0.05);
}

TEST(Svgf, WithoutHistoryAndNoiseNothingChanges) {
    for (const float v : aoOf(quadBeforeRibs(), "ao/none+filter/svgf")) ASSERT_EQ(v, 1.0f);
    EXPECT_EQ(aoOf(quadBeforeRibs(), "ao/blocks:rotation=none+filter/svgf:alpha=1,sigma-l=0"),
              aoOf(quadBeforeRibs(), "ao/blocks:rotation=none"));
}

}  // namespace
}  // namespace ombrage::test
