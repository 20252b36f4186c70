// SPDX-License-Identifier: MIT
#include <algorithm>

#include <gtest/gtest.h>
#include <glm/gtc/constants.hpp>

#include "techniques/half_plane_scene.h"
#include "techniques/technique_case.h"

namespace ombrage::test {
namespace {

std::vector<float> visibilityOf(const Scene& scene, const std::string& technique, const std::string& light) {
    RenderSettings settings;
    settings.width = 320;
    settings.height = 180;
    settings.light = light;
    settings.shadow = parsePipeline(Family::Shadow, technique);
    return measuredPlane(renderScene(scene, settings), Family::Shadow);
}

std::size_t differing(const std::vector<float>& a, const std::vector<float>& b, float tolerance) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) count += std::abs(a[i] - b[i]) > tolerance ? 1 : 0;
    return count;
}

Mesh& meshOf(Scene& scene, const std::string& name) {
    return *std::find_if(scene.meshes.begin(), scene.meshes.end(), [&](const Mesh& mesh) { return mesh.name == name; });
}

/// Positions and depth are floats, and visibility is stored with 11 bits.
constexpr double kRounding = 0.002;

TEST(Wedges, AStraightEdgeHidesASegmentOfTheLight) {
    for (const LightType type : {LightType::Spot, LightType::Rect}) {
        const HalfPlane half(type);
        const std::vector<float> row = half.row("shadow/wedges");
        int between = 0;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const double expected = half.visible(double(i) + 0.5);
            EXPECT_NEAR(row[i], expected, kRounding) << i;
            between += expected > 0 && expected < 1 ? 1 : 0;
        }
        EXPECT_GE(between, 10);
    }
}

TEST(Wedges, AWideSunShinesEvenlyInSolidAngle) {
    HalfPlane half(LightType::Sun);
    Light& sun = half.scene.lights[0];
    sun.angle_rad = 2.4f;
    const std::vector<float> row = half.row("shadow/wedges");
    // Directions evenly over the cone about the sun's: rings of equal height on the unit sphere.
    const glm::dvec3 axis = -glm::dvec3(sun.direction), side(0, 1, 0), up = glm::cross(axis, side);
    constexpr int kRings = 200, kAround = 400;
    for (const std::size_t i : {2u, 8u, 20u, 40u}) {
        int seen = 0;
        for (int r = 0; r < kRings; ++r)
            for (int a = 0; a < kAround; ++a) {
                const double c = 1 - (r + 0.5) / kRings * (1 - std::cos(1.2)), s = std::sqrt(1 - c * c),
                             angle = (a + 0.5) / kAround * 2 * glm::pi<double>();
                const glm::dvec3 d = c * axis + s * (std::cos(angle) * side + std::sin(angle) * up);
                // Above the floor, and past the sheet, which ends 99 m from the zero.
                const double reach_m = double(HalfPlane::kSheet_m) / d.z, x = double(i) + 0.5 + reach_m * d.x;
                seen += d.z > 0 && (x > 0 || x < -99 || std::abs(reach_m * d.y) > 99) ? 1 : 0;
            }
        // The sum over 80,000 directions, and kRounding.
        EXPECT_NEAR(row[i], double(seen) / (kRings * kAround), 0.004) << i;
    }
}

TEST(Wedges, TheSizeScalesThePenumbra) {
    HalfPlane half(LightType::Spot);
    const std::vector<float> narrow = half.row("shadow/wedges:size=0.5");
    half.scene.lights[0].radius_m *= 0.5f;
    EXPECT_EQ(half.row("shadow/wedges"), narrow);
}

TEST(Wedges, TheirFacesCanBeSeenWhereTheLightHasASize) {
    // Wires are drawn in one colour, red over blue, on a grey scene.
    const auto wires = [](const std::string& technique) {
        RenderSettings settings;
        settings.width = 320;
        settings.height = 180;
        settings.shadow = parsePipeline(Family::Shadow, technique);
        settings.show = {"wedge-faces"};
        const Image shown = renderScene(Bench::of("area-overlap").scene(), settings).shown.at("wedge-faces");
        std::size_t count = 0;
        for (std::size_t i = 0; i < shown.pixelCount() && shown.planeCount() > 2; ++i)
            count += shown.plane(0)[i] > 2 * shown.plane(2)[i] ? 1 : 0;
        return count;
    };
    EXPECT_GT(wires("shadow/wedges"), 500u);
    EXPECT_EQ(wires("shadow/wedges:size=0"), 0u);
}

TEST(Wedges, WithoutSizeTheyAreTheVolumes) {
    const Scene& scene = Bench::of("penumbrae").scene();
    for (const char* light : {"lamp", "sun", "spot"}) {
        SCOPED_TRACE(light);
        const std::vector<float> hard = visibilityOf(scene, "shadow/volume", light);
        EXPECT_EQ(visibilityOf(scene, "shadow/wedges:size=0", light), hard);
        // A light of a hundredth of its size: some pixels lie in the penumbra that is left.
        EXPECT_LE(differing(visibilityOf(scene, "shadow/wedges:size=0.01,horizon=false", light), hard, 0.01f), 200u);
    }
}

TEST(Wedges, ABodyWithAHoleIsStillOneBody) {
    // The lowest triangle of the ball is away from the light: the lit side still hides what it hides.
    const Scene& closed = Bench::of("penumbrae").scene();
    static Scene open = closed;
    std::vector<std::uint32_t>& indices = meshOf(open, "ball").indices;
    const std::vector<glm::vec3>& positions = meshOf(open, "ball").positions;
    std::size_t lowest = 0;
    for (std::size_t i = 0; i < indices.size(); i += 3)
        if (positions[indices[i]].y + positions[indices[i + 1]].y + positions[indices[i + 2]].y <
            positions[indices[lowest]].y + positions[indices[lowest + 1]].y + positions[indices[lowest + 2]].y)
            lowest = i;
    const auto at = indices.begin() + std::ptrdiff_t(lowest);
    indices.erase(at, at + 3);
    for (const char* light : {"lamp", "sun", "panel"})
        EXPECT_LE(
            differing(visibilityOf(open, "shadow/wedges", light), visibilityOf(closed, "shadow/wedges", light), 0.01f),
            5u)
            << light;
}

TEST(Wedges, AMirroredCasterCastsTheSame) {
    // The box is its own mirror image.
    const Scene& plain = Bench::of("penumbrae").scene();
    static Scene mirrored = plain;
    for (Instance& instance : mirrored.instances)
        if (mirrored.meshes[std::size_t(instance.mesh)].name == "board")
            instance.worldFromLocal[0] = -instance.worldFromLocal[0];
    for (const char* light : {"lamp", "panel"})
        EXPECT_LE(differing(visibilityOf(mirrored, "shadow/wedges", light), visibilityOf(plain, "shadow/wedges", light),
                            0.01f),
                  5u)
            << light;
}

TEST(Wedges, WhatSeveralCastersCoverAddsUp) {
    // The declared limit: a second sheet behind the first hides nothing more, and counts again.
    HalfPlane half(LightType::Rect);
    half.addSheet();
    const std::vector<float> row = half.row("shadow/wedges");
    for (std::size_t i = 0; i < row.size(); ++i)
        EXPECT_NEAR(row[i], std::max(0.0, 2 * half.visible(double(i) + 0.5) - 1), 2 * kRounding) << i;
}

TEST(Wedges, EdgesAroundTheLightLeaveNoNonsense) {
    // A lamp as wide as its lantern, and one that a plinth's edges touch.
    static Scene scene = Bench::of("touching").scene();
    for (Light& light : scene.lights) light.radius_m = 0.3f;
    for (const Light& light : scene.lights)
        for (const float v : visibilityOf(scene, "shadow/wedges", light.name)) ASSERT_TRUE(v >= 0.0f && v <= 1.0f);
}

}  // namespace
}  // namespace ombrage::test
