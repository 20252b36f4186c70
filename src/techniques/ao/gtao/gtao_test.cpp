// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include "techniques/ao/gtao/own.h"
#include "techniques/strip_over_floor.h"

namespace ombrage::gtao {
namespace {

constexpr double kHalfPi = 1.57079632679489662;

TEST(Gtao, ArcsAreTheIntegralOfTheirIntegrand) {
    // The midpoint rule with 2000 cells is good to 1e-6 of values about 1.
    for (const double n : {-1.2, 0.0, 0.7, 1.9})
        for (const double h : {-1.5, -0.4, 0.3, 2.0}) {
            double sum = 0;
            for (int i = 0; i < 2000; ++i) {
                const double t = (i + 0.5) / 2000 * h;
                sum += std::cos(t - n) * std::abs(std::sin(t)) * h / 2000;
            }
            EXPECT_NEAR(aoArc(n, h), sum, 2e-6) << n << ' ' << h;
        }
}

TEST(Gtao, AllSlicesOfAnOpenPlaneSeeAllOfIt) {
    // Tilted by 60 degrees, single slices see from 0.5 to 1.4; their mean is 1.
    AoReceiver receiver;
    receiver.toEye = {0, 0, 1};
    receiver.normal = receiver.shadingNormal = {std::sin(1.0471975512), 0, std::cos(1.0471975512)};
    double sum = 0;
    for (int i = 0; i < 1000; ++i) {
        const AoSlice slice(receiver, (i + 0.5) / 1000);
        sum += slice.share * aoWholeArc(slice.n_rad) / 1000;
        EXPECT_NEAR(slice.high_rad - slice.low_rad, 2 * kHalfPi, 1e-12);
    }
    EXPECT_NEAR(sum, 1.0, 1e-6);
}

TEST(Gtao, ClaimsWhatLiesOverTheHorizon) {
    // A march of 256 steps over 20 m finds an edge at 1 m to about 4 cm, which is 0.015 of visibility; power 2.
    for (const double aside : {0.5, 1.0, 3.0}) {
        const test::StripOverFloor strip{aside, 1e9, 1};
        const double mean = test::meanOverFloor(*makeIntegrand({}), test::StripProbe(strip), 20);
        EXPECT_NEAR(mean, strip.underHorizon(), 0.015) << aside;
    }
    // The same for a strip that ends: nothing passes behind it ...
    const test::StripOverFloor narrow{1, 1.5, 1};
    const double thick = test::meanOverFloor(*makeIntegrand({}), test::StripProbe(narrow), 20);
    EXPECT_NEAR(thick, narrow.underHorizon(), 0.015);
    // ... unless the horizon sinks where nothing confirms it.
    GtaoParams thin;
    thin.thickness = 0.9f;
    EXPECT_GT(test::meanOverFloor(*makeIntegrand(thin), test::StripProbe(narrow), 20), thick + 0.05);
    // What lies within the falloff counts less, and beyond the radius not at all.
    GtaoParams fading;
    fading.falloff = 1;
    const test::StripOverFloor beside{1, 1e9, 1};
    EXPECT_GT(test::meanOverFloor(*makeIntegrand(fading), test::StripProbe(beside), 3),
              test::meanOverFloor(*makeIntegrand({}), test::StripProbe(beside), 3) + 0.03);
    EXPECT_NEAR(test::meanOverFloor(*makeIntegrand({}), test::StripProbe(beside), 1.4), 1.0, 1e-9);
}

TEST(Gtao, ANormalUnderTheSurfaceLosesWhatLiesBelow) {
    // n_s 60 degrees from n_g, towards the eye: of its cosine-weighted hemisphere (1 - cos 60) / 2 lies under the
    // plane.
    AoReceiver receiver;
    receiver.toEye = receiver.shadingNormal = {0, 0, 1};
    receiver.normal = {std::sin(1.0471975512), 0, 0.5};
    receiver.up = {0, 1, 0};
    receiver.sceneRadius_m = 1;
    // An open plane through the receiver.
    class Plane final : public AoProbe {
        std::optional<double> distanceTo(const glm::dvec3&, double) const override { return std::nullopt; }
        std::optional<glm::dvec3> seenTowards(const glm::dvec3& o) const override {
            return glm::dvec3(o.x, o.y, -o.x * std::sqrt(3.0));
        }
    };
    const auto integrand = makeIntegrand({});
    double sum = 0;
    for (int i = 0; i < 4000; ++i)
        sum += integrand->sample(receiver, Plane(), {(float(i) + 0.5f) / 4000, i % 2 == 0 ? 0.25f : 0.75f, 0.5f, 0.5f});
    EXPECT_NEAR(sum / 4000, 0.75, 1e-3);
}

TEST(Gtao, ABareFloorIsOpenAndAWallHidesItsShare) {
    for (const float v : test::StripPicture(0).row("ao/gtao:radius=40")) EXPECT_EQ(v, 1.0f);

    // The first depth of the strip is found half a pixel behind its edge and up to a step later: with 64 steps over 60
    // pixels up to a pixel and a half in all, of which a step of 0.015 in visibility to the metre comes.
    const auto row = test::StripPicture(99).row("ao/gtao:radius=60,slices=16,steps=64,power=1,rotation=none");
    for (const int x : {4, 8, 16, 24}) {
        const test::StripOverFloor strip{x + 0.5, 1e9, 8};
        EXPECT_NEAR(double(row[std::size_t(x)]), strip.underHorizon(), 0.025) << x;
    }
}

TEST(Gtao, BouncesLightenByAlbedoAlone) {
    // What reflects nothing gains nothing by the light between surfaces: the fit is under V there.
    const test::StripPicture dark(99);
    EXPECT_EQ(dark.row("ao/gtao:radius=40,multi-bounce=true"), dark.row("ao/gtao:radius=40"));
}

}  // namespace
}  // namespace ombrage::gtao
