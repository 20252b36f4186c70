// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "techniques/half_plane_scene.h"
#include "techniques/technique_case.h"

namespace ombrage::test {
namespace {

std::vector<float> visibilityOf(const std::string& scene, const std::string& technique, const std::string& light) {
    RenderSettings settings;
    settings.width = 320;
    settings.height = 180;
    settings.light = light;
    settings.shadow = parsePipeline(Family::Shadow, technique);
    return measuredPlane(renderScene(Bench::of(scene).scene(), settings), Family::Shadow);
}

/// Metres between the places where a row passes two visibilities, interpolated.
double width_m(const std::vector<float>& row, float from, float to) {
    const auto place = [&](float value) {
        std::size_t i = 1;
        while (i + 1 < row.size() && row[i] < value) ++i;
        return double(i) - double((row[i] - value) / std::max(row[i] - row[i - 1], 1e-6f));
    };
    return place(to) - place(from);
}

TEST(VolumeBlur, ByContactAStraightEdgeHidesASegmentOfTheLight) {
    for (const LightType type : {LightType::Spot, LightType::Rect}) {
        const HalfPlane half(type);
        const std::vector<float> row = half.row("shadow/volume-blur:samples=256,reach=64");
        for (std::size_t i = 0; i < row.size(); ++i)
            // The hard shadow's edge lies somewhere in a pixel, and the penumbra is 11 pixels wide.
            EXPECT_NEAR(row[i], half.visible(double(i) + 0.5), 1.0 / 11) << i;
    }
}

TEST(VolumeBlur, ByContactTheWidthOfASunsEdgeIsThatOfItsDisk) {
    HalfPlane half(LightType::Sun);
    const std::vector<float> row = half.row("shadow/volume-blur:samples=256");
    // The middle half of a disk's diameter lets 0.196 to 0.804 pass; from d metres along the ray it is d tan(angle / 2)
    // wide, and longer on the floor by the cosine. Half a pixel at either end.
    const glm::vec3 l = -half.scene.lights[0].direction;
    const double along_m = double(HalfPlane::kSheet_m / l.z);
    EXPECT_NEAR(width_m(row, 0.196f, 0.804f), along_m * std::tan(0.25) / double(l.z), 1.0);
}

TEST(VolumeBlur, WhatIsBelowTheHorizonSendsNothing) {
    // A ball of 7 m whose centre is 3.5 m over the floor, and nothing between the two.
    HalfPlane half(LightType::Point);
    Light& light = half.scene.lights[0];
    light.position = {-60, 0, 3.5f};
    const std::vector<float> row = half.row("shadow/volume-blur:samples=256");
    for (std::size_t i = 0; i < row.size(); ++i) {
        const double x = double(i) + 0.5 + 60, h = 3.5, distance = std::hypot(x, h);
        // The disk that is seen, tilted by the ray's slope, less the segment below the floor.
        const double u = h / double(light.radius_m) * distance / x;
        // 257 points, of which a row across the disk, some 16, may lie on either side.
        EXPECT_NEAR(row[i], 1 - (std::acos(u) - u * std::sqrt(1 - u * u)) / 3.14159265358979, 16.0 / 257) << i;
    }
}

TEST(VolumeBlur, AShadowStaysWholeWhereAWiderPenumbraReachesIntoIt) {
    HalfPlane half(LightType::Spot);
    const float x = HalfPlane::kLightX_m, z = HalfPlane::kLight_m, high = 14, low = 6, left = -5.8f;
    half.scene = [&] {
        Scene scene = emptyScene(HalfPlane::kSize_px);
        addQuad(scene, {{-99, -99, 0}, {99, -99, 0}, {99, 99, 0}, {-99, 99, 0}}, 0.1f);
        addQuad(scene, {{-99, -99, high}, {left, -99, high}, {left, 99, high}, {-99, 99, high}}, 0.1f);
        addQuad(scene, {{5, -99, low}, {20, -99, low}, {20, 99, low}, {5, 99, low}}, 0.1f);
        scene.lights = half.scene.lights;
        return scene;
    }();
    const auto shadowOf = [&](float edge, float height) { return edge + (edge - x) * height / (z - height); };
    const float penumbra_m = HalfPlane::kRadius_m * low / (z - low), from = shadowOf(5, low), to = shadowOf(20, low);
    // The upper sheet's penumbra is 16 m to either side of what is seen left of the lower sheet, and ends in its
    // shadow.
    ASSERT_GT(from, shadowOf(left, high));
    ASSERT_LT(shadowOf(left, high), 5.0f);
    ASSERT_LT(shadowOf(left, high) + HalfPlane::kRadius_m * high / (z - high), to);
    const std::vector<float> row = half.row("shadow/volume-blur:samples=256");
    int whole = 0;
    for (std::size_t i = 0; i < row.size(); ++i) {
        // The hard shadow's edge lies somewhere in a pixel; up to 20 m the lower sheet is seen.
        if (float(i) < std::max(from + penumbra_m + 1, 20.0f) || float(i) + 1 > to - penumbra_m - 1) continue;
        EXPECT_EQ(row[i], 0.0f) << i;
        ++whole;
    }
    EXPECT_GE(whole, 8);
}

TEST(VolumeBlur, AConstantWidthIsThatWidth) {
    HalfPlane half(LightType::Spot);
    for (const char* unit : {"pixels", "metres"}) {
        // 1 m is 1 pixel. A disk of 16 m across: the middle half of it, as above.
        const std::vector<float> row =
            half.row(std::string("shadow/volume-blur:mode=constant,width=16,samples=256,unit=") + unit);
        EXPECT_NEAR(width_m(row, 0.196f, 0.804f), 8.0, 1.0) << unit;
    }
}

TEST(VolumeBlur, NothingToBlurLeavesTheVolumes) {
    EXPECT_EQ(visibilityOf("gap", "shadow/volume-blur", "sun"), visibilityOf("gap", "shadow/volume", "sun"));
    const std::vector<float> hard = visibilityOf("penumbrae", "shadow/volume", "lamp");
    EXPECT_EQ(visibilityOf("penumbrae", "shadow/volume-blur:size=0", "lamp"), hard);
    EXPECT_EQ(visibilityOf("penumbrae", "shadow/volume-blur:mode=constant,width=0", "lamp"), hard);
    EXPECT_NE(visibilityOf("penumbrae", "shadow/volume-blur", "lamp"), hard);
}

TEST(VolumeBlur, TheSilhouettesSourceChangesNothing) {
    const std::vector<float> byProcessor = visibilityOf("penumbrae", "shadow/volume-blur", "lamp");
    for (const char* source : {"geometry", "compute"}) {
        const std::vector<float> other =
            visibilityOf("penumbrae", std::string("shadow/volume-blur:silhouette=") + source, "lamp");
        std::size_t differing = 0;
        for (std::size_t i = 0; i < other.size(); ++i) differing += std::abs(other[i] - byProcessor[i]) > 0.01f ? 1 : 0;
        // Sides at one distance from the surface, in another order.
        EXPECT_LE(differing, 20u) << source;
    }
}

}  // namespace
}  // namespace ombrage::test
