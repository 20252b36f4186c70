// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <ombrage/compare.h>

#include "techniques/technique_case.h"

namespace ombrage::test {
namespace {

RenderResult shadowOf(const Scene& scene, const std::string& technique) {
    RenderSettings settings;
    settings.countSavings = true;
    settings.width = 320;
    settings.height = 180;
    settings.light = scene.lights.front().name;
    settings.shadow = parseTechnique(technique).second;
    return renderScene(scene, settings);
}

RenderResult shadowOf(const std::string& scene, const std::string& technique) {
    return shadowOf(Bench::of(scene).scene(), technique);
}

/// Each of the two steps saves by itself, and both together more.
TEST(VolumeClamped, SavesByCullingAndByClamping) {
    const auto saved = [](const char* technique) {
        return shadowOf("many-lights", technique).counters.at("fill saved");
    };
    const double nothing = saved("shadow/volume-clamped:cull=off,clamp=off"),
                 culled = saved("shadow/volume-clamped:clamp=off"), clamped = saved("shadow/volume-clamped:cull=off"),
                 both = saved("shadow/volume-clamped");
    EXPECT_EQ(nothing, 0);
    EXPECT_GT(culled, 0);
    EXPECT_GT(clamped, 0);
    EXPECT_GT(both, culled);
    EXPECT_GT(both, clamped);
}

TEST(VolumeClamped, LeavesOutWhatLiesInTheShadowOfARoof) {
    // The roof of in-shadow covers the box under it wholly, and the column and the others in part.
    const auto counters = shadowOf("in-shadow", "shadow/volume-clamped").counters;
    EXPECT_EQ(counters.at("casters culled in shadow"), 1);
    EXPECT_EQ(counters.at("casters clamped"), 5);
    EXPECT_EQ(shadowOf("in-shadow", "shadow/volume-clamped:cull=off").counters.at("casters culled in shadow"), 0);
}

/// Casters above the eye whose lit side nobody sees begin to shade at the first thing under them.
TEST(VolumeClamped, BeginsVolumesAtTheFirstReceiver) {
    EXPECT_GE(shadowOf("behind", "shadow/volume-clamped").counters.at("of those at both ends"), 1);
}

TEST(VolumeClamped, ShowsWhichCastersItLeavesOut) {
    const auto bluePixels = [](const std::string& technique) {
        RenderSettings settings;
        settings.width = 320;
        settings.height = 180;
        settings.shadow = parseTechnique(technique).second;
        settings.show = {"volume-casters"};
        const Image shown = renderScene(Bench::of("in-shadow").scene(), settings).shown.at("volume-casters");
        std::size_t count = 0;
        for (std::size_t i = 0; i < shown.pixelCount(); ++i) count += shown.plane(2)[i] > 2 * shown.plane(0)[i] ? 1 : 0;
        return count;
    };
    // The box under the roof covers some hundreds of the 57,600 pixels.
    EXPECT_GT(bluePixels("shadow/volume-clamped"), 500u);
    EXPECT_EQ(bluePixels("shadow/volume-clamped:cull=off"), 0u);
}

/// What lies behind the last receiver is cut off where the picture would show it, and left as it is elsewhere: ends
/// cost triangles.
TEST(VolumeClamped, EndsNoVolumeWhereThatSavesNothing) {
    Scene scene = Bench::of("gap").scene();
    const auto ends = shadowOf(scene, "shadow/volume-clamped:cull=off").counters;
    EXPECT_GE(ends.at("casters clamped"), 1);
    EXPECT_GT(ends.at("fill saved"), 0);
    EXPECT_GT(ends.at("volume triangles"), shadowOf(scene, "shadow/volume-zfail").counters.at("volume triangles"));

    // Towards the sky.
    for (Camera& camera : scene.cameras) camera.target = camera.position + glm::dvec3(0.1, 3, 0);
    const auto endless = shadowOf(scene, "shadow/volume-clamped:cull=off").counters;
    EXPECT_EQ(endless.at("casters clamped"), 0);
    EXPECT_EQ(endless.at("volume triangles"), shadowOf(scene, "shadow/volume-zfail").counters.at("volume triangles"));
}

/// The fill is of what is drawn: without ends and culling that of z-pass, as shadow/volume-zpass counts it.
TEST(VolumeClamped, ItsFillIsThatOfWhatItDraws) {
    EXPECT_EQ(shadowOf("in-shadow", "shadow/volume-clamped:cull=off,clamp=off").counters.at("fill"),
              shadowOf("in-shadow", "shadow/volume-zpass").counters.at("fill"));
    EXPECT_LT(shadowOf("in-shadow", "shadow/volume-clamped").counters.at("fill"),
              shadowOf("in-shadow", "shadow/volume-zpass").counters.at("fill"));
}

}  // namespace
}  // namespace ombrage::test
