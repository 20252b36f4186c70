// SPDX-License-Identifier: MIT
// Defects planted into the truth of real scenes, some of techniques that are not here: every class finds its own and
// names no other's. Where to plant is told from the truth without the classes' own rules.
#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "metrics/distance_transform.h"
#include "metrics/error_classes.h"
#include "technique_case.h"

namespace ombrage::test {
namespace {

constexpr std::size_t kPixels = std::size_t(kWidth) * kHeight;

/// A truth, a picture that starts as the truth, and which class each pixel was broken for.
class Planted {
public:
    explicit Planted(const std::string& scene, int samples = 0)
        : m_bench(Bench::of(scene)), m_light(m_bench.scene().lights.front().name) {
        truth = m_bench.shadow("", m_light, samples);
        picture = truth.visibility;
        labels.assign(kPixels, ErrorClass::None);
        question.features = &m_bench.features("", m_light);
        std::vector<std::uint32_t> dark;
        for (std::size_t i = 0; i < kPixels; ++i)
            if (truth.mask[i] == Mask::Valid && truth.visibility[i] == 0) dark.push_back(std::uint32_t(i));
        const std::vector<Blocker> blockers = question.features->blockers(dark);
        blockerDistance_m.assign(kPixels, std::numeric_limits<float>::infinity());
        for (std::size_t k = 0; k < dark.size(); ++k) blockerDistance_m[dark[k]] = blockers[k].distance_m;
        const auto distanceTo = [&](auto marked) {
            std::vector<bool> marks(kPixels);
            for (std::size_t i = 0; i < kPixels; ++i) marks[i] = marked(i);
            return distanceTransform(marks, kWidth, kHeight);
        };
        toLit_px = distanceTo([&](std::size_t i) { return truth.mask[i] != Mask::Valid || truth.visibility[i] > 0; });
        toShade_px = distanceTo([&](std::size_t i) { return truth.mask[i] != Mask::Valid || truth.visibility[i] < 1; });
    }

    void plant(std::size_t i, float value, ErrorClass label) {
        picture[i] = value;
        labels[i] = label;
    }

    /// Every class that was planted is found, and nothing else is named so.
    void expectFound(const std::vector<std::pair<ErrorClass, std::size_t>>& wanted) const {
        const ShadowMeasurement m = measureShadow(picture, truth, receivers(), question);
        for (const auto& [wantedClass, least] : wanted) {
            double planted = 0, named = 0, hits = 0;
            for (std::size_t i = 0; i < kPixels; ++i) {
                if (truth.mask[i] != Mask::Valid) continue;
                planted += labels[i] == wantedClass ? 1 : 0;
                named += m.classes[i] == wantedClass ? 1 : 0;
                hits += labels[i] == wantedClass && m.classes[i] == wantedClass ? 1 : 0;
            }
            EXPECT_GE(planted, double(least)) << errorClassKey(wantedClass);
            EXPECT_GE(hits, 0.95 * planted) << "recall of " << errorClassKey(wantedClass);
            EXPECT_GE(hits, 0.95 * named) << "precision of " << errorClassKey(wantedClass);
        }
    }

    const Receivers& receivers() const { return m_bench.receivers(""); }

    ShadowTruth truth;
    std::vector<float> picture;
    std::vector<ErrorClass> labels;
    ShadowQuestion question;
    std::vector<float> blockerDistance_m;     ///< of pixels in full shadow
    std::vector<float> toLit_px, toShade_px;  ///< other pixels that are not measured count as both

private:
    Bench& m_bench;
    std::string m_light;
};

constexpr float kFarFromEdges_px = 12;

// A map of 1 cm texels that does everything wrong that maps can do, each in its own part of the picture.
TEST(PlantedErrors, OfAMapAreToldApart) {
    for (const char* scene : {"gap", "resting", "sphere"}) {
        SCOPED_TRACE(scene);
        Planted p(scene);
        constexpr double kTexel_m = 0.01;
        p.question.footprint.texel_m = kTexel_m;
        // The last cascade ends 60 pixels from the right border.
        p.question.inRange.assign(kPixels, true);
        for (std::size_t i = 0; i < kPixels; ++i) {
            const int x = int(i % kWidth), y = int(i / kWidth);
            if (p.truth.mask[i] != Mask::Valid) continue;
            const bool isLit = p.truth.visibility[i] == 1;
            if (x >= kWidth - 60) {
                p.question.inRange[i] = false;
                if (y % 2 == 0) p.plant(i, isLit ? 0 : 1, ErrorClass::Missing);
            } else if (isLit && p.toShade_px[i] > kFarFromEdges_px && (x + 2 * y) % 5 < 2) {
                p.plant(i, 0, ErrorClass::Acne);
            } else if (!isLit && double(p.blockerDistance_m[i]) < 2 * kTexel_m) {
                p.plant(i, 1, ErrorClass::ContactGap);
            } else if (!isLit && p.toLit_px[i] > kFarFromEdges_px && double(p.blockerDistance_m[i]) > 10 * kTexel_m &&
                       y % 3 == 0) {
                p.plant(i, 0.4f, ErrorClass::Leak);
            } else if (y % 4 < 2) {
                // Steps of two pixels: the neighbour's answer. Beside a contact that would be to blame, too.
                const std::size_t j = i - std::size_t(x % 2);
                const bool isContact = double(p.blockerDistance_m[i]) < 6 * kTexel_m;
                if (!isContact && p.receivers().triangle[i] == p.receivers().triangle[j] &&
                    p.truth.mask[j] == Mask::Valid && p.truth.visibility[j] != p.truth.visibility[i])
                    p.plant(i, p.truth.visibility[j], ErrorClass::Alias);
            }
        }
        p.expectFound(
            {{ErrorClass::Missing, 100}, {ErrorClass::Acne, 10000}, {ErrorClass::Leak, 300}, {ErrorClass::Alias, 30}});
        if (std::string(scene) != "sphere") p.expectFound({{ErrorClass::ContactGap, 5}});
    }
}

// Streaks from an edge that a volume counts twice, across the lit floor, and a hole in the volume.
TEST(PlantedErrors, OfAVolumeAreFalseShadowsAndLeaks) {
    for (const char* scene : {"gap", "two-casters", "three-casters"}) {
        SCOPED_TRACE(scene);
        Planted p(scene);
        for (std::size_t i = 0; i < kPixels; ++i) {
            const int x = int(i % kWidth), y = int(i / kWidth);
            if (p.truth.mask[i] != Mask::Valid) continue;
            const bool isLit = p.truth.visibility[i] == 1;
            if (isLit && p.toShade_px[i] > kFarFromEdges_px && std::abs(2 * x - 3 * y + 40) % 90 < 6)
                p.plant(i, 0, ErrorClass::FalseShadow);
            // Beyond 4 pixels from the blocker, which is a contact.
            const double contact_m = 8 * double(p.receivers().pixelSize_m[i]);
            if (!isLit && p.toLit_px[i] > kFarFromEdges_px && double(p.blockerDistance_m[i]) > contact_m && y % 7 < 3)
                p.plant(i, 1, ErrorClass::Leak);
        }
        p.expectFound({{ErrorClass::FalseShadow, 3000}, {ErrorClass::Leak, 300}});
    }
}

// Moments let light through where casters overlap; the share under several of them says so.
TEST(PlantedErrors, OfMomentsLieUnderSeveralCasters) {
    Planted p("two-casters");
    std::vector<std::uint32_t> umbra;
    for (std::size_t i = 0; i < kPixels; ++i)
        if (p.truth.mask[i] == Mask::Valid && p.truth.visibility[i] == 0 && p.toLit_px[i] > kFarFromEdges_px)
            umbra.push_back(std::uint32_t(i));
    const std::vector<int> layers = p.question.features->layers(umbra);
    std::size_t leaking = 0;
    for (std::size_t k = 0; k < umbra.size(); ++k)
        if (layers[k] >= 2) {
            p.plant(umbra[k], 0.3f, ErrorClass::Leak);
            ++leaking;
        }
    EXPECT_GT(leaking, 300u);
    EXPECT_LT(leaking, umbra.size()) << "some of the umbra lies under one caster";
    p.expectFound({{ErrorClass::Leak, 300}});
    const Metrics m = measureShadow(p.picture, p.truth, p.receivers(), p.question).metrics;
    EXPECT_DOUBLE_EQ(*m.at("leak_layered"), *m.at("leak"));
}

// The technique itself: what it lets through far from the light is a leak, along the upper caster's edge within the shadow
// of the lower one, on either side of it.
TEST(PlantedErrors, OfAVarianceShadowMapAreLeaks) {
    Planted p("two-casters");
    RenderSettings settings;
    settings.width = kWidth;
    settings.height = kHeight;
    settings.light = "lamp";
    settings.shadow = parsePipeline(Family::Shadow, "shadow/vsm:kernel=31,bleeding=0");
    const RenderResult result = renderScene(Bench::of("two-casters").scene(), settings);
    const std::vector<float> shown = measuredPlane(result, Family::Shadow);
    p.question.footprint = result.footprint.begin()->second;
    std::size_t leaking = 0;
    for (std::size_t i = 0; i < kPixels; ++i) {
        if (p.truth.mask[i] != Mask::Valid || p.toLit_px[i] <= kFarFromEdges_px || p.truth.visibility[i] > 0) continue;
        p.plant(i, shown[i], shown[i] > 0.1f ? ErrorClass::Leak : ErrorClass::None);
        leaking += shown[i] > 0.1f ? 1 : 0;
    }
    EXPECT_GT(leaking, 100u);
    p.expectFound({{ErrorClass::Leak, 100}});
    const Metrics m = measureShadow(p.picture, p.truth, p.receivers(), p.question).metrics;
    EXPECT_GT(*m.at("leak_layered"), 0.25 * *m.at("leak"));
    EXPECT_LT(*m.at("leak_layered"), 0.75 * *m.at("leak"));
}

/// The same shadows of a lamp of another size: what a technique shows that misjudges the width of penumbrae.
std::vector<float> withLampScaled(const std::string& name, const Receivers& receivers, float factor, int samples) {
    Scene scene = loadScene(name);
    Light& lamp = scene.lights.front();
    lamp.radius_m *= factor;
    lamp.size_m *= factor;
    lamp.angle_rad *= factor;
    ReferenceOptions options;
    options.width = kWidth;
    options.height = kHeight;
    options.samplesPerPixel = samples;
    return Reference(scene).shadow(receivers, scene.cameras.front(), 0, options).visibility;
}

TEST(PlantedErrors, OfAPenumbraAreBlurs) {
    constexpr int kSamples = 128;
    const std::string scene = "area-overlap";
    for (const float factor : {1.4f, 0.5f, 0.0f}) {
        SCOPED_TRACE(factor);
        const ErrorClass label = factor > 1 ? ErrorClass::OverBlur : ErrorClass::UnderBlur;
        Planted p(scene, kSamples);
        const std::vector<float> picture =
            factor > 0 ? withLampScaled(scene, p.receivers(), factor, kSamples) : hardShadow(p.truth);
        const ErrorZones zones = errorZones(p.truth, p.receivers());
        for (std::size_t i = 0; i < kPixels; ++i) {
            const double error = std::abs(double(picture[i]) - double(p.truth.visibility[i]));
            // Where the penumbra is narrower than a pixel the truth has a hard edge, and alias comes first.
            if (p.truth.mask[i] == Mask::Valid && error > 0.05 + 3 * double(p.truth.standardError[i]) &&
                zones.toHardEdge_px[i] > 2)
                p.plant(i, picture[i], label);
        }
        p.expectFound({{label, 300}});
    }
}

}  // namespace
}  // namespace ombrage::test
