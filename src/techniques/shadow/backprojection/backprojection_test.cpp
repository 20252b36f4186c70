// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "techniques/half_plane_scene.h"
#include "techniques/sized_lights.h"

namespace ombrage::test {
namespace {

/// Texels of a few centimetres, most of them looked at one by one.
const std::string kFine = "shadow/backprojection:max-texels=64,max-radius=1024,resolution=2048";

TEST(Backprojection, AStraightEdgeHidesASegmentOfTheLight) {
    for (const LightType type : {LightType::Spot, LightType::Rect}) {
        const HalfPlane half(type);
        const std::vector<float> row = half.row(kFine);
        // The penumbra is some 230 texels wide, and the edge lies somewhere in one; outer ones stand for up to four.
        // From x = 10 m on the floor belongs to a face of the cube that sees the sheet at a slant, and so near to the
        // light that it asks for more texels than faces overlap by: it counts as a smaller one.
        for (std::size_t i = 0; i < row.size(); ++i)
            EXPECT_NEAR(row[i], half.visible(double(i) + 0.5), i < 10 ? 0.02 : 0.13)
                << lightTypeName(type) << " at " << i;
    }
}

TEST(Backprojection, ASunIsADisk) {
    HalfPlane half(LightType::Sun);
    half.scene.lights[0].direction = {0, 0, -1};
    const std::vector<float> row = half.row(kFine);
    // The disk's radius on the floor; the map's texel is 5 cm there.
    const double radius_m = std::tan(0.25) * double(HalfPlane::kSheet_m);
    for (std::size_t i = 0; i < 8; ++i) {
        const double u = std::clamp((double(i) + 0.5) / radius_m, 0.0, 1.0);
        EXPECT_NEAR(row[i], 1 - (std::acos(u) - u * std::sqrt(1 - u * u)) / 3.14159265358979, 0.02) << i;
    }
}

TEST(Backprojection, WhatIsBelowTheHorizonSendsNothing) {
    // A ball of 7 m whose centre is 3.5 m over the floor, and nothing between the two; the noise of 256 rays.
    HalfPlane half(LightType::Point);
    half.scene.instances.pop_back();
    half.scene.lights[0].position = {-60, 0, 3.5f};
    const std::vector<float> row = half.row(kFine), truth = half.row("shadow/ray-traced:samples=256");
    for (std::size_t i = 0; i < row.size(); ++i) EXPECT_NEAR(row[i], truth[i], 0.02) << i;
    EXPECT_LT(row[20], 0.9f);
}

TEST(Backprojection, ALightWithoutSizeIsThatOfShadowMap) {
    for (const char* scene : {"gap", "room", "two-casters", "fence"}) {
        const Scene& known = Bench::of(scene).scene();
        EXPECT_EQ(measuredPlane(renderFirstLight(known, "shadow/backprojection"), Family::Shadow),
                  measuredPlane(renderFirstLight(known, "shadow/map"), Family::Shadow))
            << scene;
    }
}

TEST(Backprojection, LightsOfASizeLeaveSurfacesAndCornersClean) {
    for (const char* name : {"gap", "in-shadow", "room", "menger", "resting", "corner", "nave", "bumpy"}) {
        const Metrics metrics = measureFirstLight(withSizedLight(name, 0.05f), "shadow/backprojection", 64);
        EXPECT_LE(metrics.at("acne").value(), 0.001) << name;
        EXPECT_LE(metrics.at("wrong").value(), 0.0005) << name;
    }
}

// Neighbours in a picture ask the pyramid for different levels, and casters at all heights for different regions.
TEST(Backprojection, ContactsStayDark) {
    for (const char* name : {"mirrored", "resting", "two-casters", "figure"})
        EXPECT_LE(measureFirstLight(withSizedLight(name, 0.05f), "shadow/backprojection", 64).at("hard_ratio").value(),
                  0.35)
            << name;
}

TEST(Backprojection, ALightThatAsksForTooManyTexelsCountsAsASmallerOne) {
    // What is cut off is the penumbra, not the umbra.
    const Scene scene = withSizedLight("figure", 0.05f);
    EXPECT_LE(measureFirstLight(scene, "shadow/backprojection:max-radius=16", 64).at("leak").value(), 0.001);
}

TEST(Backprojection, ClosedGapsLetNoLightThrough) {
    // Two boards, one above the other: light between their texels.
    const Scene scene = loadScene("area-overlap");
    const double open = measureFirstLight(scene, "shadow/backprojection:gaps=open", 64).at("hard_ratio").value();
    EXPECT_LE(measureFirstLight(scene, "shadow/backprojection", 64).at("hard_ratio").value(), 0.8 * open);
}

}  // namespace
}  // namespace ombrage::test
