// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "techniques/half_plane_scene.h"
#include "techniques/sized_lights.h"

namespace ombrage::test {
namespace {

/// As many samples as there are, the same for all pixels, on texels of a few centimetres.
const std::string kFine =
    "shadow/pcss:rotation=none,filter-samples=64,blocker-samples=64,max-radius=1024,resolution=2048";

/// Metres between the places where a row passes two visibilities, interpolated.
double width_m(const std::vector<float>& row, float from, float to) {
    const auto place = [&](float value) {
        std::size_t i = 1;
        while (i + 1 < row.size() && row[i] < value) ++i;
        return double(i) - double((row[i] - value) / std::max(row[i] - row[i - 1], 1e-6f));
    };
    return place(to) - place(from);
}

/// A picture of what the lookup finds for the half plane, at the floor's pixel that starts at x metres.
float found(const HalfPlane& half, const std::string& name, int x) {
    RenderSettings settings = squareSettings(HalfPlane::kSize_px);
    settings.shadow = parsePipeline(Family::Shadow, kFine);
    settings.light = "light";
    settings.show = {name};
    const Image shown = renderFlat(half.scene, settings).shownRaw.at(name);
    return shown.plane(0)[std::size_t(HalfPlane::kSize_px / 2 * HalfPlane::kSize_px + HalfPlane::kSize_px / 2 + x)];
}

TEST(Pcss, AStraightEdgeHidesASegmentOfTheLight) {
    for (const LightType type : {LightType::Spot, LightType::Rect}) {
        const HalfPlane half(type);
        const std::vector<float> row = half.row(kFine);
        // Of 64 points some 8 lie along any chord, and some of them on its wrong side. From x = 10 m on the floor
        // belongs to a face of the cube that sees the sheet at a slant, and one mean distance is a compromise.
        for (std::size_t i = 0; i < row.size(); ++i)
            EXPECT_NEAR(row[i], half.visible(double(i) + 0.5), i < 10 ? 2.5 / 64 : 0.08)
                << lightTypeName(type) << " at " << i;
    }
}

TEST(Pcss, ASphereIsTheDiskOfItsCone) {
    const HalfPlane half(LightType::Point);
    const std::vector<float> row = half.row(kFine), truth = half.row("shadow/ray-traced:samples=256");
    // As above, and the noise of 256 rays; the slanted face begins in the midst of the penumbra.
    for (std::size_t i = 0; i < row.size(); ++i) EXPECT_NEAR(row[i], truth[i], i < 10 ? 4.0 / 64 : 0.12) << i;
}

TEST(Pcss, TheWidthOfASunsEdgeIsThatOfItsDisk) {
    const HalfPlane half(LightType::Sun);
    const std::vector<float> row = half.row(kFine);
    // The middle half of a disk's diameter lets 0.196 to 0.804 pass; from d metres along the ray it is d tan(angle / 2)
    // wide, and longer on the floor by the cosine. Half a pixel, and of 64 points two, at either end.
    const glm::vec3 l = -half.scene.lights[0].direction;
    const double along_m = double(HalfPlane::kSheet_m / l.z);
    EXPECT_NEAR(width_m(row, 0.196f, 0.804f), along_m * std::tan(0.25) / double(l.z), 0.6);
}

TEST(Pcss, ShowsTheWidthOfThePenumbraInMetres) {
    // Light size times the distance from caster to receiver over that from light to caster (Fernando 2005): the light
    // stands 20 m over the floor and 11 m over the sheet. Depths along the view's axis are exact to a part in a
    // million.
    const double farther = 9.0 / 11.0;
    EXPECT_NEAR(found(HalfPlane(LightType::Spot), "penumbra-width", 5), 14 * farther, 1e-3);
    EXPECT_NEAR(found(HalfPlane(LightType::Rect), "penumbra-width", 5), 14 * farther, 1e-3);
    EXPECT_NEAR(found(HalfPlane(LightType::Spot), "blocker-depth", 5), 11, 1e-3);
    EXPECT_EQ(found(HalfPlane(LightType::Spot), "penumbra-width", 40), 0);

    // A sun's is 2 tan(angle / 2) times the distance along its ray.
    HalfPlane sun(LightType::Sun);
    sun.scene.lights[0].direction = {0, 0, -1};
    EXPECT_NEAR(found(sun, "penumbra-width", 0), 2 * std::tan(0.25) * double(HalfPlane::kSheet_m), 1e-3);
}

TEST(Pcss, ShowsWhereTheLimitCutsPenumbraeOff) {
    HalfPlane half(LightType::Spot);
    EXPECT_EQ(found(half, "clipped", 5), 0);
    RenderSettings settings = squareSettings(HalfPlane::kSize_px);
    settings.shadow = parsePipeline(Family::Shadow, "shadow/pcss:max-radius=4");
    settings.light = "light";
    settings.show = {"clipped"};
    const Image shown = renderFlat(half.scene, settings).shownRaw.at("clipped");
    EXPECT_EQ(shown.plane(0)[std::size_t(HalfPlane::kSize_px / 2 * HalfPlane::kSize_px + HalfPlane::kSize_px / 2 + 5)],
              1);
}

TEST(Pcss, WhatIsBelowTheHorizonSendsNothing) {
    // A ball of 7 m whose centre is 3.5 m over the floor, and nothing between the two.
    HalfPlane half(LightType::Point);
    half.scene.instances.pop_back();
    half.scene.lights[0].position = {-60, 0, 3.5f};
    const std::vector<float> row = half.row(kFine), truth = half.row("shadow/ray-traced:samples=256");
    for (std::size_t i = 0; i < row.size(); ++i) EXPECT_NEAR(row[i], truth[i], 4.0 / 64) << i;
    EXPECT_LT(row[20], 0.9f);
}

TEST(Pcss, ALightWithoutSizeIsThatOfShadowMap) {
    for (const char* scene : {"gap", "room", "two-casters", "fence"}) {
        const Scene& known = Bench::of(scene).scene();
        EXPECT_EQ(measuredPlane(renderFirstLight(known, "shadow/pcss"), Family::Shadow),
                  measuredPlane(renderFirstLight(known, "shadow/map"), Family::Shadow))
            << scene;
    }
}

// Large kernels must not find the receiver's own surface, nor walls that rise beside it.
TEST(Pcss, LightsOfASizeLeaveSurfacesAndCornersClean) {
    for (const char* name : {"gap", "in-shadow", "room", "menger", "resting", "corner", "nave", "bumpy"}) {
        const Scene scene = withSizedLight(name, 0.05f);
        EXPECT_LE(measureFirstLight(scene, "shadow/pcss", 64).at("acne").value(), 0.001) << name;
    }
    // What the published search makes of the same corner: ten times the bound.
    EXPECT_GT(measureFirstLight(withSizedLight("corner", 0.05f), "shadow/pcss:blockers=depth", 64).at("acne").value(),
              0.005);
}

TEST(Pcss, ContactsBelowATallCasterStayDark) {
    // Of the wide search that the tall ones ask for, the low ones fill a small part.
    for (const char* name : {"menger", "two-casters", "thin-wall"}) {
        const Scene scene = withSizedLight(name, 0.05f);
        EXPECT_LE(measureFirstLight(scene, "shadow/pcss", 64).at("wrong").value(), 0.0005) << name;
    }
}

}  // namespace
}  // namespace ombrage::test
