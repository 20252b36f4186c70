// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>

#include "techniques/half_plane_scene.h"
#include "techniques/shared/disks.h"
#include "techniques/technique_case.h"

namespace ombrage::test {
namespace {

TEST(PcfDisks, VogelsPointsLieOnHisSpiral) {
    const auto disk = vogelDisk(16);
    ASSERT_EQ(disk.size(), 16u);
    glm::vec2 mean(0);
    for (int k = 0; k < 16; ++k) {
        const glm::vec2 p = disk[std::size_t(k)];
        // Each point stands for an equal part of the area: r^2 = (k + 1/2) / 16. Floats of some 1 have 6e-8.
        EXPECT_NEAR(glm::dot(p, p), (float(k) + 0.5f) / 16, 1e-6f) << k;
        mean += p / 16.0f;
        if (k == 0) continue;
        // From one to the next 137.5077 degrees; up to 36 rad, whose floats have 4e-6.
        const glm::vec2 q = disk[std::size_t(k - 1)];
        const float turn = std::atan2(q.x * p.y - q.y * p.x, glm::dot(q, p));
        EXPECT_NEAR(turn, glm::radians(137.50776f), 2e-5f) << k;
    }
    // Its terms turn about the centre: no longer together than the last of them, 1/16.
    EXPECT_LE(glm::length(mean), 1.0f / 16);
}

TEST(PcfDisks, PoissonsPointsKeepApart) {
    for (int count : {1, 8, 16, 64}) {
        const auto disk = poissonDisk(count);
        ASSERT_EQ(disk.size(), std::size_t(count));
        glm::vec2 mean(0);
        float nearest = 2;
        for (std::size_t i = 0; i < disk.size(); ++i) {
            EXPECT_LE(glm::dot(disk[i], disk[i]), 1.0f);
            mean += disk[i] / float(count);
            for (std::size_t j = 0; j < i; ++j) nearest = std::min(nearest, glm::distance(disk[i], disk[j]));
        }
        // A hexagonal lattice of so many in the disk has a distance of 1.90 / sqrt(count); the best of random
        // candidates reach some 0.7 of it, random points 0.05.
        if (count > 1) {
            EXPECT_GE(nearest, 0.5f * 1.9f / std::sqrt(float(count))) << count;
        }
        // Random points have 0.7 / sqrt(count), these less.
        if (count > 1) {
            EXPECT_LE(glm::length(mean), 0.7f / std::sqrt(float(count))) << count;
        }
        EXPECT_EQ(disk, poissonDisk(count));
    }
}

/// Half a floor in the shadow of a sheet, a sun straight above: the shadow's edge runs along x = 0.
struct Ramp {
    HalfPlane half{LightType::Sun};

    Ramp() {
        half.scene.lights[0].direction = {0, 0, -1};
        half.scene.lights[0].angle_rad = 0;
        // Out of the picture, so that the map reaches as far to the right as to the left and the edge lies in its
        // middle.
        addQuad(half.scene, {{98, -99, 9}, {99, -99, 9}, {99, 99, 9}, {98, 99, 9}}, 0.1f);
    }

    /// Visibility along x from -64 m, a metre a pixel. Texels of 198 m * 1.002 / `resolution`.
    std::vector<float> row(const std::string& params) const {
        RenderSettings settings = squareSettings(HalfPlane::kSize_px);
        settings.shadow = parsePipeline(Family::Shadow, "shadow/pcf:resolution=64," + params);
        settings.light = "light";
        const RenderResult result = renderFlat(half.scene, settings);
        const auto plane = result.visibility.begin()->second.plane(0);
        const auto first = plane.begin() + HalfPlane::kSize_px / 2 * HalfPlane::kSize_px;
        return {first, first + HalfPlane::kSize_px};
    }

    static double texel_m() { return 198 * 1.002 / 64; }
};

/// The box of `size` texels about x over the map's step: texels whose centre lies under the sheet are dark.
double boxOverStep(double x, double texel_m, int size, double edge) {
    const double from = x / texel_m - size / 2.0, to = x / texel_m + size / 2.0;
    double lit = 0;
    for (int i = int(std::floor(from)); i < to; ++i)
        if (i + 0.5 > edge) lit += std::min(double(i + 1), to) - std::max(double(i), from);
    return lit / size;
}

TEST(Pcf, AStraightEdgeIsARampOfTheGridsWidth) {
    const Ramp ramp;
    for (const char* compare : {"texels", "hardware"})
        for (int size : {1, 2, 3, 4, 5, 9}) {
            SCOPED_TRACE(std::string(compare) + " " + std::to_string(size));
            const auto row = ramp.row("crease=0,size=" + std::to_string(size) + ",compare=" + compare);
            const double width_m = size * Ramp::texel_m();
            int between = 0;
            for (int i = HalfPlane::kSize_px / 2; i < HalfPlane::kSize_px; ++i) {
                const double x = i + 0.5 - HalfPlane::kSize_px / 2;
                // The map's centre and the step lie at x = 0, between two texels. 1/128 of a weight is what hardware
                // may round a bilinear one to on either axis.
                EXPECT_NEAR(row[std::size_t(i)], boxOverStep(x, Ramp::texel_m(), size, 0), 1.0 / 64) << x;
                EXPECT_NEAR(row[std::size_t(i)], std::clamp(0.5 + x / width_m, 0.0, 1.0), 1.0 / 64) << x;
                between += row[std::size_t(i)] > 0.01f && row[std::size_t(i)] < 0.99f ? 1 : 0;
            }
            EXPECT_NEAR(between, width_m / 2, 1.0);
        }
}

TEST(Pcf, ADiskOfNoRadiusIsAHardMap) {
    const Ramp ramp;
    for (float v : ramp.row("kernel=poisson,radius=0")) EXPECT_TRUE(v == 0.0f || v == 1.0f) << v;
}

TEST(Pcf, TurningTheDiskChangesThePenumbraOnly) {
    const Ramp ramp;
    const auto still = ramp.row("crease=0,kernel=vogel,radius=6,rotation=none");
    for (const char* rotation : {"interleaved", "blue-noise"}) {
        const auto turned = ramp.row(std::string("crease=0,kernel=vogel,radius=6,rotation=") + rotation);
        int differ = 0;
        for (std::size_t i = HalfPlane::kSize_px / 2; i < still.size(); ++i) {
            const double x = double(i) + 0.5 - HalfPlane::kSize_px / 2;
            differ += turned[i] != still[i] ? 1 : 0;
            // Half a texel beside the disk is the nearest centre of what it touches.
            if (x > 6.5 * Ramp::texel_m()) {
                EXPECT_EQ(turned[i], 1.0f) << rotation << x;
            }
        }
        EXPECT_GE(differ, 4) << rotation;
    }
}

/// The darkest of a roof of two faces, which nothing shades: the sun comes `elevation_deg` over the first and grazes
/// the second even more, from `azimuth_deg`.
float darkestOfARoof(const std::string& params, float elevation_deg, float azimuth_deg) {
    Scene scene = emptyScene(HalfPlane::kSize_px);
    addQuad(scene, {{-40, -40, 0}, {0, -40, 0}, {0, 40, 0}, {-40, 40, 0}}, 0.1f);
    addQuad(scene, {{0, -40, 0}, {40, -40, -0.7f}, {40, 40, -0.7f}, {0, 40, 0}}, 0.1f);
    Light sun;
    sun.name = "light";
    const float up = glm::radians(elevation_deg), around = glm::radians(azimuth_deg);
    sun.direction = {std::cos(up) * std::cos(around), std::cos(up) * std::sin(around), -std::sin(up)};
    scene.lights = {sun};
    RenderSettings settings = squareSettings(HalfPlane::kSize_px);
    settings.shadow = parsePipeline(Family::Shadow, "shadow/pcf:crease=0," + params);
    settings.light = "light";
    const RenderResult result = renderFlat(scene, settings);
    const auto plane = result.visibility.begin()->second.plane(0);
    return *std::min_element(plane.begin(), plane.end());
}

TEST(Pcf, BiasGrowsWithTheKernel) {
    for (const char* params :
         {"size=9", "kernel=vogel,radius=8,samples=64", "size=9,compare=hardware", "size=9,bias=slope",
          "kernel=poisson,radius=8,compare=hardware", "size=9,bias=oriented", "size=9,bias=receiver-plane"})
        for (float azimuth_deg : {0.0f, 45.0f, 70.0f}) {
            // 4.5 texels aside at 4 degrees the plane lies 64 texels nearer to the sun. A half float of a sum over 81.
            EXPECT_GE(darkestOfARoof(params, 4, azimuth_deg), 0.999f) << params << " " << azimuth_deg;
        }
    // A bias that does not grow with the kernel shows it.
    EXPECT_LT(darkestOfARoof("size=9,bias=constant", 4, 0), 0.7f);
}

TEST(Pcf, CornersOfRoomsDoNotDarkenThemselves) {
    // Two faces at a right angle, no other caster: all is lit. The sun comes 30 degrees off one's normal.
    Scene scene = emptyScene(HalfPlane::kSize_px);
    addQuad(scene, {{-40, -40, 0}, {0, -40, 0}, {0, 40, 0}, {-40, 40, 0}}, 0.1f);
    addQuad(scene, {{0, -40, 0}, {0, -40, 9}, {0, 40, 9}, {0, 40, 0}}, 0.1f);
    // Without something behind them neither could shade anything, and the map would leave them out.
    addQuad(scene, {{-60, -40, -1}, {-50, -40, -1}, {-50, 40, -1}, {-60, 40, -1}}, 0.1f);
    addQuad(scene, {{50, -40, -1}, {60, -40, -1}, {60, 40, -1}, {50, 40, -1}}, 0.1f);
    Light sun;
    sun.name = "light";
    sun.direction = glm::normalize(glm::vec3(0.5f, 0, -0.8660254f));
    scene.lights = {sun};
    const auto least = [&](const std::string& crease) {
        RenderSettings settings = squareSettings(HalfPlane::kSize_px);
        settings.shadow = parsePipeline(Family::Shadow, "shadow/pcf:resolution=48,size=5,crease=" + crease);
        settings.light = "light";
        const RenderResult result = renderFlat(scene, settings);
        const auto plane = result.visibility.begin()->second.plane(0);
        const auto row = plane.begin() + HalfPlane::kSize_px / 2 * HalfPlane::kSize_px;
        // The floor left of the wall: 40 m, 40 pixels. The wall is seen edge on.
        return *std::min_element(row + 26, row + 64);
    };
    // The wall rises 2.3 texels for each one aside, by slope 0.58 and 1.73.
    EXPECT_LT(least("0,max-slope=0"), 0.9f);
    EXPECT_GE(least("10"), 0.999f);  // a half float of a sum over 25
}

TEST(Pcf, ADiskWiderThanTheMapIsABlurAndNoMore) {
    // Faces of 16 texels cannot overlap by 32 on each side. A lamp over a floor, most of which nothing shades.
    Scene scene = emptyScene(HalfPlane::kSize_px);
    addQuad(scene, {{-40, -40, 0}, {40, -40, 0}, {40, 40, 0}, {-40, 40, 0}}, 0.1f);
    addQuad(scene, {{-5, -5, 5}, {5, -5, 5}, {5, 5, 5}, {-5, 5, 5}}, 0.1f);
    Light lamp;
    lamp.name = "light";
    lamp.type = LightType::Point;
    lamp.position = {0, 0, 20};
    scene.lights = {lamp};
    RenderSettings settings = squareSettings(HalfPlane::kSize_px);
    settings.shadow = parsePipeline(Family::Shadow, "shadow/pcf:resolution=16,kernel=vogel,radius=32");
    settings.light = "light";
    const RenderResult result = renderFlat(scene, settings);
    const auto plane = result.visibility.begin()->second.plane(0);
    // The shade is 13 m wide in a picture of 128 m: 1 percent, and the disk, half a face wide, can but spread it.
    double sum = 0;
    for (float v : plane) sum += double(v);
    EXPECT_GT(sum / double(plane.size()), 0.85);
}

}  // namespace
}  // namespace ombrage::test
