// SPDX-License-Identifier: MIT
// Every built-in scene shows the failure that it was made for, and not with the techniques that are free of it.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include <gtest/gtest.h>
#include <ombrage/compare.h>
#include <ombrage/error.h>
#include <ombrage/metrics.h>
#include <ombrage/reference.h>
#include <ombrage/renderer.h>

#include "metrics/error_classes.h"
#include "scene/builtin.h"
#include "scenes/expectations.h"

namespace ombrage::test {
namespace {

namespace fs = std::filesystem;
const fs::path kFolder = fs::path(OMBRAGE_SOURCE_DIR) / "tests/scenes/expectations";

Renderer& sharedRenderer() {
    static Renderer renderer([] {
        RendererOptions options;
        options.debugContext = true;
        return options;
    }());
    return renderer;
}

RenderSettings settingsOf(const SceneExpectations& expected) {
    RenderSettings settings;
    settings.width = kExpectationWidth;
    settings.height = kExpectationHeight;
    settings.camera = expected.camera;
    settings.time_s = expected.time_s;
    return settings;
}

/// A scene with its truths, made once.
class Measured {
public:
    explicit Measured(const SceneExpectations& expected)
        : m_expected(expected),
          m_scene(loadScene(expected.scene)),
          m_moved(moved(m_scene, expected.time_s)),
          m_reference(m_moved) {
        m_options.width = kExpectationWidth;
        m_options.height = kExpectationHeight;
        m_receivers = m_reference.receivers(camera(), m_options);
        m_positions = m_reference.positions(m_receivers);
        sharedRenderer().setScene(m_scene);
    }

    Metrics of(const std::string& technique) {
        const auto [family, pipeline] = parseTechnique(technique);
        RenderSettings settings = settingsOf(m_expected);
        (family == Family::Shadow ? settings.shadow : settings.ao) = pipeline;
        settings.light = light().name;
        const RenderResult result = sharedRenderer().render(settings);
        for (const std::string& message : result.debugMessages) ADD_FAILURE() << "OpenGL says " << message;
        for (int p = 0; p < result.picture.planeCount(); ++p)
            for (const float value : result.picture.plane(p))
                if (!std::isfinite(value)) {
                    ADD_FAILURE() << technique << " gives a pixel that is no number";
                    break;
                }
        const bool isShadow = family == Family::Shadow;
        const auto plane = isShadow ? result.visibility.begin()->second.plane(0) : result.ao->plane(0);
        m_question.footprint = result.footprint.empty() ? TexelFootprint{} : result.footprint.begin()->second;
        m_question.inRange =
            result.range.empty() ? std::vector<bool>() : inRange(result.range.begin()->second, m_positions, camera());
        m_instance = result.instance;
        m_triangle = result.triangle;
        return measure(isShadow, {plane.begin(), plane.end()});
    }

    /// The same for a picture of one value, seen through the technique of the last call.
    Metrics ofConstant(bool isShadow, float value) {
        return measure(isShadow, std::vector<float>(std::size_t(kExpectationWidth * kExpectationHeight), value));
    }

    /// The mean of the truth over its valid pixels. After of().
    float bestConstant(bool isShadow) const {
        const std::vector<float>& values = isShadow ? m_shadow.visibility : m_ao.visibility;
        const std::vector<Mask>& mask = isShadow ? m_shadow.mask : m_ao.mask;
        double sum = 0, count = 0;
        for (std::size_t i = 0; i < values.size(); ++i)
            if (mask[i] == Mask::Valid) {
                sum += double(values[i]);
                ++count;
            }
        return float(sum / count);
    }

    /// Of a plain hard shadow without any error of its own, where the light has a size.
    std::optional<Metrics> ofHardShadow() {
        if (!light().hasSize()) return std::nullopt;
        return measure(true, hardShadow(m_shadow));
    }

private:
    static Scene moved(Scene scene, double time_s) {
        animate(scene, time_s);
        return scene;
    }
    const Camera& camera() const { return m_moved.cameras[std::size_t(m_moved.cameraIndex(m_expected.camera))]; }
    const Light& light() const { return m_moved.lights[std::size_t(m_moved.lightIndex(m_expected.light))]; }

    Metrics measure(bool isShadow, const std::vector<float>& image) {
        if (isShadow) {
            if (m_shadow.visibility.empty()) {
                // 64 samples err by some 0.01 in a penumbra, a fifth of what counts as an error there.
                m_options.samplesPerPixel = light().hasSize() ? 64 : 0;
                m_shadow = m_reference.shadow(m_receivers, camera(), m_moved.lightIndex(m_expected.light), m_options);
                m_features = m_reference.shadowFeatures(m_receivers, m_moved.lightIndex(m_expected.light), m_options);
                m_question.features = &m_features;
            }
            ShadowTruth truth = m_shadow;
            maskDisagreement(truth.mask, truth.maskedShare, m_receivers, m_instance, m_triangle);
            return measureShadow(image, truth, m_receivers, m_question).metrics;
        }
        if (m_ao.visibility.empty()) {
            m_options.samplesPerPixel = 64;
            m_ao = m_reference.ao(m_receivers, camera(), m_options);
        }
        AoTruth truth = m_ao;
        maskDisagreement(truth.mask, truth.maskedShare, m_receivers, m_instance, m_triangle);
        return measureAo(image, truth);
    }

    SceneExpectations m_expected;
    Scene m_scene, m_moved;
    Reference m_reference;
    ReferenceOptions m_options;
    Receivers m_receivers;
    ShadowTruth m_shadow;
    AoTruth m_ao;
    ShadowFeatures m_features;
    ShadowQuestion m_question;
    std::vector<glm::dvec3> m_positions;
    std::vector<std::uint32_t> m_instance, m_triangle;
};

class EveryScene : public testing::TestWithParam<std::string> {
protected:
    SceneExpectations expected() const { return readExpectations(kFolder, GetParam()); }
};

TEST_P(EveryScene, ShowsWhatItDeclaresAndNothingElse) {
    const SceneExpectations scene = expected();
    Measured measured(scene);
    std::map<std::string, Metrics> known;
    bool brokenByLight = false, brokenByDark = false, brokenByMean = false, brokenByHard = false;
    for (const std::vector<Expectation>* list : {&scene.shows, &scene.holds})
        for (const Expectation& expectation : *list) {
            if (known.count(expectation.technique) == 0)
                known[expectation.technique] = measured.of(expectation.technique);
            const Metrics& metrics = known[expectation.technique];
            ASSERT_TRUE(metrics.count(expectation.metric)) << expectation.metric;
            const std::optional<double> value = metrics.at(expectation.metric);
            EXPECT_TRUE(expectation.meets(value))
                << scene.scene << ": " << expectation.technique << " has " << expectation.metric << " = "
                << value.value_or(NAN) << ", declared " << (expectation.min ? "at least " : "at most ")
                << expectation.min.value_or(expectation.max.value_or(0));
            // What must not appear would appear in a picture of one value.
            if (list == &scene.holds) {
                const bool isShadow = parseTechnique(expectation.technique).first == Family::Shadow;
                const auto breaks = [&](float constant) {
                    return !expectation.meets(measured.ofConstant(isShadow, constant).at(expectation.metric));
                };
                brokenByLight = brokenByLight || breaks(1.0f);
                brokenByDark = brokenByDark || breaks(0.0f);
                brokenByMean = brokenByMean || breaks(measured.bestConstant(isShadow));
                const std::optional<Metrics> hard = isShadow ? measured.ofHardShadow() : std::nullopt;
                brokenByHard = brokenByHard || !hard || !expectation.meets(hard->at(expectation.metric));
            }
        }
    EXPECT_TRUE(brokenByLight) << "a picture that is lit everywhere meets all that must hold";
    EXPECT_TRUE(brokenByDark) << "a picture that is dark everywhere meets all that must hold";
    EXPECT_TRUE(brokenByMean) << "the best picture of one value meets all that must hold";
    EXPECT_TRUE(brokenByHard) << "a plain hard shadow meets all that must hold";
}

std::vector<std::string> sceneNames() {
    std::vector<std::string> names;
    for (const BuiltinScene& scene : builtinScenes()) names.push_back(scene.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryScene, testing::ValuesIn(sceneNames()), [](const auto& name) {
    std::string test = name.param;
    std::replace(test.begin(), test.end(), '-', '_');
    return test;
});

TEST(SceneExpectationFiles, BelongToScenes) {
    const std::vector<std::string> names = sceneNames();
    for (const auto& entry : fs::directory_iterator(kFolder))
        EXPECT_EQ(std::count(names.begin(), names.end(), entry.path().stem().string()), 1) << entry.path();
}

// The value as its maker leaves it, before repairScene(): a program may hand such a scene over as it is.
TEST(DegenerateScene, RendersWithoutANumberlessPixelEvenUnrepaired) {
    const std::vector<Scene> scenes = {makeBuiltinScene("degenerate"), loadScene("degenerate")};
    for (const Scene& scene : scenes) {
        Reference reference(scene);
        ReferenceOptions options;
        options.width = kExpectationWidth;
        options.height = kExpectationHeight;
        const Receivers receivers = reference.receivers(scene.cameras[0], options);
        const ShadowTruth truth = reference.shadow(receivers, scene.cameras[0], 0, options);
        for (const float value : truth.visibility) ASSERT_TRUE(std::isfinite(value));
        options.samplesPerPixel = 8;
        const AoTruth ao = reference.ao(receivers, scene.cameras[0], options);
        for (const float value : ao.visibility) ASSERT_TRUE(std::isfinite(value));

        for (const TechniqueInfo& info : techniques()) {
            RenderSettings settings;
            settings.width = kExpectationWidth;
            settings.height = kExpectationHeight;
            const Pipeline self{{info.id, {}}};
            if (info.family == Family::Shadow) settings.shadow = self;
            if (info.family == Family::Ao) settings.ao = self;
            if (info.family == Family::Filter) settings.ao.push_back({info.id, {}});
            if (info.family == Family::Indirect) settings.indirect = self;
            if (info.family == Family::Aa) settings.aa = self;
            // What takes no sun has a lamp in its place.
            Scene lit = scene;
            if (!info.domain.sun) {
                lit.lights[0].type = LightType::Point;
                lit.lights[0].position = {1, 4, 1};
            }
            sharedRenderer().setScene(lit);
            const RenderResult result = sharedRenderer().render(settings);
            std::size_t seen = 0, numberless = 0;
            for (const std::uint32_t instance : result.instance) seen += instance != kNoHit ? 1 : 0;
            for (int p = 0; p < result.picture.planeCount(); ++p)
                for (const float value : result.picture.plane(p)) numberless += std::isfinite(value) ? 0 : 1;
            EXPECT_GE(seen, 10000u) << info.id;
            EXPECT_EQ(numberless, 0u) << info.id;
        }
    }
}

}  // namespace
}  // namespace ombrage::test
