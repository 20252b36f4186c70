// SPDX-License-Identifier: MIT
#include "techniques/shared/light_region.h"

#include <limits>

#include <gtest/gtest.h>

#include "render_fixture.h"

namespace ombrage {
namespace {

// A point x aside at the depth d lies at its pixel 200 + 100 x / d, one y above at 100 + 100 y / d.
using hand::viewAhead;
using Rect = gl::DrawState::Rect;

LightRegion regionOf(const CameraView& view, const glm::vec3& position, float range_m,
                     LightType type = LightType::Point) {
    Light light;
    light.type = type;
    light.position = position;
    light.range_m = range_m;
    LightFrame frame{0, &light};
    frame.position = position;
    return LightRegion(view, frame);
}

/// Sides of a rectangle in pixels from the lower left corner.
struct Sides {
    double left, bottom, right, top;
};

/// The rectangle holds what the light's sphere covers, and is no larger than what the box around the sphere does, but
/// for rounding to whole pixels and one more as margin.
void expectScissor(const LightRegion& region, const Sides& sphere, const Sides& box) {
    EXPECT_FALSE(region.empty);
    ASSERT_TRUE(region.scissor.has_value());
    constexpr int kMost_px = 2;
    const Rect r = *region.scissor;
    EXPECT_LE(r.x, sphere.left);
    EXPECT_GE(r.x, box.left - kMost_px);
    EXPECT_LE(r.y, sphere.bottom);
    EXPECT_GE(r.y, box.bottom - kMost_px);
    EXPECT_GE(r.x + r.width, sphere.right);
    EXPECT_LE(r.x + r.width, box.right + kMost_px);
    EXPECT_GE(r.y + r.height, sphere.top);
    EXPECT_LE(r.y + r.height, box.top + kMost_px);
}

/// Depths are taken a ten thousandth of the distance farther apart, for rounding; twice that is allowed.
void expectDepths(const LightRegion& region, double lower, double upper, double slack) {
    ASSERT_TRUE(region.depthBounds.has_value());
    EXPECT_LE(region.depthBounds->x, lower);
    EXPECT_GE(region.depthBounds->x, lower - slack);
    EXPECT_GE(region.depthBounds->y, upper);
    EXPECT_LE(region.depthBounds->y, upper + slack);
}

TEST(LightRegion, ALampAheadReachesAKnownRectangleAndDepths) {
    // The sphere of 1 m at 5 m is seen under 1 / sqrt(24), the box's near face at 4 m under 1/4.
    const LightRegion region = regionOf(viewAhead(), {0, 0, -5}, 1);
    expectScissor(region, {179.6, 79.6, 220.4, 120.4}, {175, 75, 225, 125});
    expectDepths(region, 0.01 / 6, 0.01 / 4, 2e-4 * 0.01 / 4);
}

TEST(LightRegion, ALampAsideReachesThatSide) {
    // The sphere's sides: tan(atan(2/5) -+ asin(1/sqrt(29))) = 0.1962, 0.6371; tan(atan(1/5) -+ asin(1/sqrt(26))) = 0,
    // 0.4167. The box's: 1/6 and 3/4, 0 and 2/4.
    expectScissor(regionOf(viewAhead(), {2, 1, -5}, 1), {219.6, 100, 263.7, 141.6}, {216.6, 100, 275, 150});
    expectScissor(regionOf(viewAhead(), {-2, -1, -5}, 1), {136.3, 58.4, 180.4, 100}, {125, 50, 183.4, 100});
}

TEST(LightRegion, EndsWhereThePictureDoes) {
    // tan(atan(-8/5) + asin(4/sqrt(89))) = -0.647; the box's far corner: -4/9. Above and below it is cut.
    const LightRegion region = regionOf(viewAhead(), {-8, 0, -5}, 4);
    expectScissor(region, {0, 0, 135.3, 200}, {0, 0, 155.6, 200});
    EXPECT_GE(region.scissor->x, 0);
    EXPECT_GE(region.scissor->y, 0);
    EXPECT_LE(region.scissor->y + region.scissor->height, 200);
}

TEST(LightRegion, OrthographicRectanglesAreTheSpheresOwn) {
    // 8 m by 4 m in 400 by 200 pixels: 50 a metre.
    const CameraView view = viewAhead(4.0f);
    const LightRegion region = regionOf(view, {1, 0.5f, -5}, 1);
    expectScissor(region, {200, 75, 300, 175}, {200, 75, 300, 175});
    const double length_m = double(view.far_m) - 0.01;
    expectDepths(region, 1 - 5.99 / length_m, 1 - 3.99 / length_m, 2e-4 * 6 / length_m);
}

TEST(LightRegion, IsEmptyBehindTheEyeAndBesideThePicture) {
    for (const CameraView& view : {viewAhead(), viewAhead(4.0f)}) {
        EXPECT_TRUE(regionOf(view, {0, 0, 5}, 1).empty) << "behind";
        EXPECT_TRUE(regionOf(view, {30, 0, -5}, 1).empty) << "right";
        EXPECT_TRUE(regionOf(view, {-30, 0, -5}, 1).empty) << "left";
        EXPECT_TRUE(regionOf(view, {0, 30, -5}, 1).empty) << "above";
        EXPECT_TRUE(regionOf(view, {0, -30, -5}, 1).empty) << "below";
        EXPECT_FALSE(regionOf(view, {0, 0, -5}, 1).empty);
    }
    // Just reaching over the near plane, and just not.
    EXPECT_FALSE(regionOf(viewAhead(), {0, 0, 0.95f}, 1).empty);
    EXPECT_TRUE(regionOf(viewAhead(), {0, 0, 0.995f}, 1).empty);
}

TEST(LightRegion, AroundTheEyeEveryPixelMayBeReached) {
    const LightRegion region = regionOf(viewAhead(), {0, 0, 0.5f}, 1);
    EXPECT_FALSE(region.empty);
    EXPECT_FALSE(region.scissor.has_value());
    expectDepths(region, 0.01 / 0.5, 1, 2e-4 * 0.01 / 0.5);
    EXPECT_EQ(region.depthBounds->y, 1.0f);
}

TEST(LightRegion, SunsAndLampsWithoutRangeReachEverything) {
    const float endless = std::numeric_limits<float>::infinity();
    for (const LightRegion& region :
         {regionOf(viewAhead(), {0, 0, -5}, 1, LightType::Sun), regionOf(viewAhead(), {0, 0, -5}, endless),
          regionOf(viewAhead(), {0, 0, 5}, endless)}) {
        EXPECT_FALSE(region.empty);
        EXPECT_FALSE(region.scissor.has_value());
        EXPECT_FALSE(region.depthBounds.has_value());
    }
}

}  // namespace
}  // namespace ombrage
