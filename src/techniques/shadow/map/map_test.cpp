// SPDX-License-Identifier: MIT
// Defects made by turning one parameter: the pixels that it breaks are known from the render without it, and the class
// must find them (recall) and name nothing else so (precision).
#include <algorithm>

#include <gtest/gtest.h>
#include <ombrage/compare.h>

#include "metrics/error_classes.h"
#include "techniques/half_plane_scene.h"
#include "techniques/technique_case.h"

namespace ombrage::test {
namespace {

/// A technique's picture of a scene under its first light, and what is wrong with it.
struct Shot {
    std::vector<float> visibility;
    ShadowMeasurement measured;
    ShadowTruth truth;
    const Receivers* receivers = nullptr;
    std::vector<bool> inRange;
};

Shot shoot(const std::string& scene, const std::string& technique, int samples = 0) {
    Bench& bench = Bench::of(scene);
    RenderSettings settings;
    settings.width = kWidth;
    settings.height = kHeight;
    settings.light = bench.scene().lights.front().name;
    settings.shadow = parseTechnique(technique).second;
    const RenderResult result = renderScene(bench.scene(), settings);
    Shot shot;
    shot.visibility = measuredPlane(result, Family::Shadow);
    shot.truth = bench.shadow("", settings.light, samples);
    const Receivers& receivers = bench.receivers("");
    maskDisagreement(shot.truth.mask, shot.truth.maskedShare, receivers, result.instance, result.triangle);
    ShadowQuestion question;
    question.footprint = result.footprint.begin()->second;
    question.inRange = bench.covered(result.range.begin()->second, "");
    question.features = &bench.features("", settings.light);
    shot.receivers = &receivers;
    shot.inRange = question.inRange;
    shot.measured = measureShadow(shot.visibility, shot.truth, receivers, question);
    return shot;
}

struct Found {
    double precision = 0, recall = 0;
    std::size_t planted = 0;
};

/// The planted pixels are those that are over in `broken` and right in `sound`; what `sound` breaks as well has another
/// cause. @param fromEdge_px planted pixels nearer to a true hard edge are left out: there alias comes first
Found find(const Shot& broken, const Shot& sound, ErrorClass wanted, float fromEdge_px = -1) {
    const std::vector<float> toEdge_px = errorZones(broken.truth, *broken.receivers).toHardEdge_px;
    double hits = 0, named = 0;
    Found found;
    for (std::size_t i = 0; i < broken.visibility.size(); ++i) {
        if (toEdge_px[i] <= fromEdge_px) continue;
        const ErrorClass c = broken.measured.classes[i];
        const bool isPlanted = c != ErrorClass::None && sound.measured.classes[i] == ErrorClass::None;
        found.planted += isPlanted ? 1 : 0;
        named += c == wanted ? 1 : 0;
        hits += isPlanted && c == wanted ? 1 : 0;
    }
    found.precision = named > 0 ? hits / named : 0;
    found.recall = found.planted > 0 ? hits / double(found.planted) : 0;
    return found;
}

void expectFound(const Found& found, std::size_t atLeast) {
    EXPECT_GE(found.planted, atLeast);
    EXPECT_GE(found.recall, 0.95);
    EXPECT_GE(found.precision, 0.95);
}

double shareOfOver(const Shot& shot, const char* key) {
    return *shot.measured.metrics.at(key) / *shot.measured.metrics.at("over");
}

TEST(ShadowMapErrors, WithoutABiasThePlaneReadsAcne) {
    const Shot broken = shoot("plane-grazing", "shadow/map:bias=constant,constant-bias=0,extrapolate=false");
    expectFound(find(broken, shoot("plane-grazing", "shadow/map"), ErrorClass::Acne), 50000);
    // Nothing else but alias, within a stretched texel of the one shadow's edge, where either may be the cause.
    EXPECT_GE(shareOfOver(broken, "acne"), 0.95);
    EXPECT_DOUBLE_EQ(shareOfOver(broken, "acne") + shareOfOver(broken, "alias"), 1);
}

TEST(ShadowMapErrors, AWideBiasReadsContactGap) {
    // Far sides, 1 mm over the floor: 3 texels of bias lose what is nearer to them.
    expectFound(find(shoot("gap", "shadow/map:bias=second-depth,constant-bias=3,resolution=256"),
                     shoot("gap", "shadow/map:resolution=256"), ErrorClass::ContactGap),
                100);
}

TEST(ShadowMapErrors, ACoarseMapReadsAlias) {
    for (const char* scene : {"gap", "sphere", "two-casters"}) {
        SCOPED_TRACE(scene);
        const Shot broken = shoot(scene, "shadow/map:resolution=64");
        expectFound(find(broken, shoot(scene, "shadow/map:resolution=4096"), ErrorClass::Alias), 150);
        EXPECT_GE(shareOfOver(broken, "alias"), 0.95);
        EXPECT_GE(*broken.measured.metrics.at("edge_px"), 0.3);
    }
}

TEST(ShadowMap, DoubleSidedSheetsKeepBothSides) {
    Scene scene = emptyScene(HalfPlane::kSize_px);
    addQuad(scene, {{-60, -60, 0}, {60, -60, 0}, {60, 60, 0}, {-60, 60, 0}}, 0.1f);
    addQuad(scene, {{-9, -9, 9}, {9, -9, 9}, {9, 9, 9}, {-9, 9, 9}}, 0.1f);
    Light sun;
    sun.name = "light";
    sun.direction = glm::normalize(glm::vec3(1, 0, -0.3f));
    scene.lights = {sun};
    const auto shadowed = [&](const std::string& params) {
        RenderSettings settings = squareSettings(HalfPlane::kSize_px);
        settings.shadow = parsePipeline(Family::Shadow, "shadow/map:" + params);
        settings.light = "light";
        const RenderResult result = renderFlat(scene, settings);
        const auto plane = result.visibility.begin()->second.plane(0);
        return std::count(plane.begin(), plane.end(), 0.0f);
    };
    const auto all = shadowed("cull=none");
    EXPECT_GE(all, 300);  // 18 m by 18 m, some of it under the sheet itself
    EXPECT_EQ(shadowed("cull=back"), all);
    EXPECT_EQ(shadowed("cull=front"), all);
    // One-sided, it shows the sun one side alone.
    for (Material& material : scene.materials) material.doubleSided = false;
    EXPECT_EQ(std::min(shadowed("cull=back"), shadowed("cull=front")), 0);
}

TEST(ShadowMapErrors, CastersThatAreCulledReadLeak) {
    expectFound(find(shoot("open-mesh", "shadow/map:cull=back"), shoot("open-mesh", "shadow/map"), ErrorClass::Leak, 4),
                4000);
}

TEST(ShadowMapErrors, AHardShadowOfALargeLampReadsUnderBlur) {
    // 128 samples err by some 0.01 in a penumbra, a fifth of what counts.
    const Shot shot = shoot("area-overlap", "shadow/map:resolution=2048", 128);
    EXPECT_GE(shareOfOver(shot, "under_blur"), 0.95);
    EXPECT_EQ(*shot.measured.metrics.at("over_blur"), 0);
    // At best it is the plain hard shadow.
    EXPECT_GE(*shot.measured.metrics.at("hard_ratio"), 1);
}

TEST(ShadowMapRange, IsThatOfItsMap) {
    // The map leaves out what no caster can shade: the floor, but for what lies behind the box.
    const Shot shot = shoot("gap", "shadow/map");
    EXPECT_EQ(*shot.measured.metrics.at("missing"), 0);
    EXPECT_GT(std::count(shot.inRange.begin(), shot.inRange.end(), true), 10000);
    EXPECT_GT(std::count(shot.inRange.begin(), shot.inRange.end(), false), 1000);
    // What lies outside is lit in truth: else it would be missing.
    for (std::size_t i = 0; i < shot.inRange.size(); ++i)
        if (shot.truth.mask[i] == Mask::Valid && !shot.inRange[i]) {
            ASSERT_EQ(shot.truth.visibility[i], 1) << i;
        }
}

}  // namespace
}  // namespace ombrage::test
