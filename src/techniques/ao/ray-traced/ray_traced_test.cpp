// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include "techniques/ambient_measure.h"
#include "techniques/corner_picture.h"

namespace ombrage::test {
namespace {

const char* const kPatterns[] = {"random", "sobol", "rotated", "blue-noise"};

std::vector<float> planeOf(const RenderResult& result) {
    return measuredPlane(result, Family::Ao);
}

/// A part of `corner` that shows floor and walls, small enough for many rays.
RenderSettings cornerSettings(const std::string& params) {
    return AmbientMeasure::settings("ao/ray-traced:progressive=true," + params);
}

TEST(AmbientRays, AWallHasItsClosedForm) {
    const CornerPicture picture(20);
    for (const char* pattern : kPatterns) {
        const std::vector<float> row =
            picture.row(std::string("ao/ray-traced:samples=256,radius=16,pattern=") + pattern);
        // Random samples err by 1/2 / sqrt(256) at most: 4 deviations. Stratified ones by less than a fifth of it.
        const double tolerance = std::string(pattern) == "random" ? 4 * 0.5 / 16 : 0.025;
        for (std::size_t i = 0; i < row.size(); ++i)
            EXPECT_NEAR(row[i], CornerPicture::nearWall(double(i) + 0.5, 16), tolerance) << pattern << " at " << i;
    }
}

TEST(AmbientRays, ReachTheTruthAndConvergeToIt) {
    for (const char* scene : {"corner", "nave"}) {
        // 2048 samples are closer to the answer than 256 of the same kind by a factor of 8^0.65 and more.
        const AmbientMeasure measure(scene, "T1", 2048);

        // Least squares of log rmse over log samples.
        double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
        for (int samples = 4; samples <= 256; samples *= 4) {
            const Metrics metrics = measure.of("ao/ray-traced:samples=" + std::to_string(samples));
            const double rmse = *metrics.at("rmse");
            if (samples == 256) {
                EXPECT_GE(*metrics.at("psnr"), 40.0) << scene;
            }
            const double x = std::log(double(samples)), y = std::log(rmse);
            RecordProperty(std::string(scene) + "_" + std::to_string(samples), std::to_string(rmse));
            n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
        }
        const double slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
        RecordProperty(std::string(scene) + "_slope", std::to_string(slope));
        EXPECT_LE(slope, -0.45) << scene;
    }
}

TEST(AmbientRays, FramesThatFollowEachOtherAddTheirRays) {
    const Scene scene = loadScene("corner");
    RenderSettings once = cornerSettings("samples=48"), often = cornerSettings("samples=16");
    often.frames = 3;
    const std::vector<float> whole = planeOf(renderScene(scene, once));
    EXPECT_EQ(planeOf(renderScene(scene, often)), whole);

    // A frame that follows the last one goes on; frame 0 starts anew, and so does any other view or seed.
    often.frames = 1;
    const std::vector<float> first = planeOf(renderScene(scene, often));
    EXPECT_NE(first, whole);
    often.firstFrame = 1;
    often.frames = 2;
    Renderer renderer;
    renderer.setScene(scene);
    RenderSettings next = often;
    next.firstFrame = 0;
    next.frames = 1;
    EXPECT_EQ(planeOf(renderer.render(next)), first);
    EXPECT_EQ(planeOf(renderer.render(often)), whole);
    next.firstFrame = 3;
    next.seed = 2;
    const RenderResult seeded = renderer.render(next);
    EXPECT_EQ(seeded.counters.at("rays per pixel so far"), 16);
    next.firstFrame = 4;
    next.camera = "top";
    EXPECT_EQ(renderer.render(next).counters.at("rays per pixel so far"), 16);
    next.firstFrame = 5;
    EXPECT_EQ(renderer.render(next).counters.at("rays per pixel so far"), 32);

    often.ao = parsePipeline(Family::Ao, "ao/ray-traced:samples=16");
    often.firstFrame = 0;
    often.frames = 3;
    EXPECT_EQ(planeOf(renderScene(scene, often)), first);
}

TEST(AmbientRays, WhatMovesStartsThemAnew) {
    Scene scene = loadScene("cornell");
    Renderer renderer;
    renderer.setScene(scene);
    RenderSettings settings = cornerSettings("samples=4");
    renderer.render(settings);
    Scene moved = scene;
    moved.instances.back().worldFromLocal[3].x -= 0.2;
    renderer.moveScene(moved);
    settings.firstFrame = 1;
    const RenderResult after = renderer.render(settings);
    EXPECT_EQ(after.counters.at("rays per pixel so far"), 4);
    settings.firstFrame = 0;
    EXPECT_EQ(planeOf(after), planeOf(renderScene(moved, settings)));
}

TEST(AmbientRays, WhatCastsNoShadowOccludesStill) {
    Scene scene = loadScene("cornell");
    const RenderSettings settings = cornerSettings("samples=4");
    const std::vector<float> before = planeOf(renderScene(scene, settings));
    // As in the truth: occlusion is no light's shadow.
    for (Model& model : scene.models) model.casts = false;
    EXPECT_EQ(planeOf(renderScene(scene, settings)), before);
}

TEST(AmbientRays, CountsThem) {
    const CornerPicture picture(20);
    RenderSettings settings = squareSettings(CornerPicture::kSize_px);
    settings.ao = parsePipeline(Family::Ao, "ao/ray-traced:samples=40");
    // Every pixel shows a surface.
    EXPECT_EQ(renderFlat(picture.scene, settings).counters.at("rays"), 64.0 * 64 * 40);
}

}  // namespace
}  // namespace ombrage::test
