// SPDX-License-Identifier: MIT
// What every technique must hold, read from its own tests.json: budgets against the truth, none of them met by a
// degenerate answer, live parameters, variants that compile, facts that must not change. No technique is named here.
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include <ombrage/error.h>

#include "gl/context.h"
#include "lab/plan.h"
#include "metrics/error_classes.h"
#include "render/technique.h"
#include "technique_case.h"

namespace ombrage::test {
namespace {

using nlohmann::json;

class EveryTechnique : public testing::TestWithParam<std::string> {
protected:
    const TechniqueInfo& info() const { return technique(GetParam()); }

    /// Settings that put the technique, with parameters, into its family's place.
    RenderSettings settingsFor(const json& entry) const {
        RenderSettings settings;
        settings.countSavings = true;
        settings.width = kWidth;
        settings.height = kHeight;
        settings.camera = entry.value("camera", "");
        // The truth's normals are those of the geometry.
        const std::string normals = entry.value("normals", "map");
        EXPECT_TRUE(normals == "map" || normals == "geometry") << normals;
        if (normals == "geometry") settings.normals = NormalSource::Geometry;
        const std::string text = entry.value("pipeline", technicalSheet(info()).value("pipeline", GetParam()));
        const bool aoFirst = info().family == Family::Filter || info().family == Family::Ao;
        Pipeline pipeline = parsePipeline(aoFirst ? Family::Ao : info().family, text);
        for (TechniqueSpec& spec : pipeline)
            if (spec.id == GetParam() && entry.contains("params"))
                for (const auto& [key, value] : entry["params"].items())
                    spec.params.emplace_back(key, value.is_string() ? value.get<std::string>() : value.dump());
        placeOf(info().family, settings) = pipeline;
        return settings;
    }

    RenderResult render(const json& entry, int width = kWidth, int height = kHeight) const {
        Bench& bench = Bench::of(entry.at("scene"));
        RenderSettings settings = settingsFor(entry);
        settings.width = width;
        settings.height = height;
        if (info().family == Family::Shadow) settings.light = entry.value("light", bench.scene().lights.front().name);
        RenderResult result = renderScene(bench.scene(), settings);
        EXPECT_TRUE(result.debugMessages.empty()) << result.debugMessages.front();
        return result;
    }

    /// The entry for renders that need no budget: the scene named under "live", or the first budget's.
    json liveEntry() const {
        const json sheet = technicalSheet(info());
        json entry = {{"scene", "gap"}};
        if (!sheet.value("budgets", json::array()).empty()) entry["scene"] = sheet["budgets"][0]["scene"];
        if (sheet.contains("live") && sheet["live"].contains("scene")) entry["scene"] = sheet["live"]["scene"];
        return entry;
    }

    /// Metrics of an image against the truth of a budget's scene, camera, light and kind.
    Metrics measure(const json& budget, const std::vector<float>& image, const RenderResult& result,
                    std::size_t* valid) const {
        Bench& bench = Bench::of(budget.at("scene"));
        const std::string camera = budget.value("camera", ""), light = budget.value("light", "");
        const Receivers& receivers = bench.receivers(camera);
        if (info().family == Family::Shadow) {
            ShadowTruth truth = shadowTruth(budget);
            maskDisagreement(truth.mask, truth.maskedShare, receivers, result.instance, result.triangle);
            const Light& shining = bench.scene().lights[std::size_t(bench.scene().lightIndex(light))];
            ShadowQuestion question;
            if (!result.footprint.empty()) question.footprint = result.footprint.begin()->second;
            if (!result.range.empty()) question.inRange = bench.covered(result.range.begin()->second, camera);
            question.inDomain = domainMask(settingsFor(budget).shadow, shining, bench.traits(), receivers);
            question.features = &bench.features(camera, light, budget.value("truth", "shadow"));
            const ShadowMeasurement measured = measureShadow(image, truth, receivers, question);
            if (valid) *valid = measured.validCount;
            return measured.metrics;
        }
        AoTruth truth = aoTruth(budget);
        maskDisagreement(truth.mask, truth.maskedShare, receivers, result.instance, result.triangle);
        if (valid) *valid = std::size_t(std::count(truth.mask.begin(), truth.mask.end(), Mask::Valid));
        return measureAo(image, truth);
    }

    /// The shadows that a budget names, of all casters where it names no kind.
    const ShadowTruth& shadowTruth(const json& budget) const {
        return Bench::of(budget.at("scene"))
            .shadow(budget.value("camera", ""), budget.value("light", ""), budget.value("spp", 0),
                    budget.value("truth", "shadow"));
    }

    /// The ambient truth that a budget names, T1 where it names none.
    const AoTruth& aoTruth(const json& budget) const {
        return Bench::of(budget.at("scene"))
            .ao(budget.value("camera", ""), budget.value("spp", 128), budget.value("truth", "T1"),
                settingsFor(budget).ao);
    }

    static bool meets(const json& budget, const Metrics& metrics) {
        const auto value = metrics.at(budget.at("metric"));
        if (!value) return false;  // a budget over no pixel says nothing
        return (!budget.contains("max") || *value <= budget["max"].get<double>()) &&
               (!budget.contains("min") || *value >= budget["min"].get<double>());
    }
};

TEST_P(EveryTechnique, MeetsItsBudgets) {
    json lastRun;
    Metrics metrics;
    std::size_t valid = 0;
    for (const json& budget : technicalSheet(info()).value("budgets", json::array())) {
        // Budgets of one run stand together and share it.
        json run = budget;
        for (const char* key : {"metric", "max", "min", "reason"}) run.erase(key);
        if (run != lastRun) {
            const RenderResult result = render(budget);
            metrics = measure(budget, measuredPlane(result, info().family), result, &valid);
            lastRun = run;
        }
        const std::string metric = budget.at("metric");
        ASSERT_TRUE(metrics.count(metric)) << metric;
        EXPECT_GE(valid, 10000u) << budget.dump();
        EXPECT_TRUE(meets(budget, metrics))
            << budget.dump() << "\n  measured " << metric << " = " << metrics.at(metric).value_or(NAN);
    }
}

// A budget that a constant picture meets says nothing. Budgets of one scene, camera and light stand together: every
// degenerate answer must break at least one of them; for a light with a size the plain hard shadow is one, too.
TEST_P(EveryTechnique, DegenerateAnswersBreakItsBudgets) {
    std::map<std::string, std::vector<json>> groups;
    for (const json& budget : technicalSheet(info()).value("budgets", json::array()))
        groups[budget.at("scene").get<std::string>() + budget.value("camera", "") + budget.value("light", "") +
               budget.value("normals", "") + budget.value("truth", "") + budget.value("pipeline", "") +
               budget.value("params", json::object()).dump() + std::to_string(budget.value("spp", 0))]
            .push_back(budget);
    for (const auto& [name, budgets] : groups) {
        const RenderResult result = render(budgets.front());
        // The best constant is the truth's mean over valid pixels.
        const bool isShadow = info().family == Family::Shadow;
        const auto& truthValues =
            isShadow ? shadowTruth(budgets.front()).visibility : aoTruth(budgets.front()).visibility;
        const auto& mask = isShadow ? shadowTruth(budgets.front()).mask : aoTruth(budgets.front()).mask;
        double sum = 0, count = 0;
        for (std::size_t i = 0; i < mask.size(); ++i)
            if (mask[i] == Mask::Valid) {
                sum += double(truthValues[i]);
                ++count;
            }
        const std::size_t pixels = std::size_t(kWidth * kHeight);
        std::map<std::string, std::vector<float>> answers{
            {"all lit", std::vector<float>(pixels, 1.0f)},
            {"all dark", std::vector<float>(pixels, 0.0f)},
            {"the best constant", std::vector<float>(pixels, float(sum / count))}};
        if (isShadow && shadowTruth(budgets.front()).soft)
            answers["the plain hard shadow"] = hardShadow(shadowTruth(budgets.front()));
        for (const auto& [answer, image] : answers) {
            const Metrics metrics = measure(budgets.front(), image, result, nullptr);
            const bool met =
                std::all_of(budgets.begin(), budgets.end(), [&](const json& budget) { return meets(budget, metrics); });
            EXPECT_FALSE(met) << answer << " meets every budget of " << name;
        }
    }
}

// Both ends of each range (and every choice) must give at least two different answers; parameters listed under
// "costOnly" must change what is drawn or held instead.
TEST_P(EveryTechnique, EveryParameterIsLive) {
    const json sheet = technicalSheet(info());
    const json live = sheet.value("live", json::object());
    const auto costOnly = sheet.value("costOnly", std::vector<std::string>{});
    for (const ParamInfo& param : info().params) {
        std::vector<std::string> values;
        if (param.type == ombrage::ParamType::Enum)
            values = param.choices;
        else if (param.type == ombrage::ParamType::Bool)
            values = {"false", "true"};
        else if (param.type == ombrage::ParamType::Int)
            values = {std::to_string(std::int64_t(param.minimum)), std::to_string(std::int64_t(param.maximum))};
        else
            values = {toString(ParamValue(param.minimum)), toString(ParamValue(param.maximum))};

        json entry = liveEntry();
        if (live.contains(param.key)) {
            const json special = live[param.key];
            if (special.contains("scene")) entry["scene"] = special["scene"];
            if (special.contains("params")) entry["params"] = special["params"];
            if (special.contains("values")) values = special["values"].get<std::vector<std::string>>();
        }
        std::set<std::vector<float>> answers;
        std::set<std::string> costs;
        for (const std::string& value : values) {
            entry["params"][param.key] = value;
            // Two renders, so that a cache can show itself.
            render(entry, 320, 180);
            const RenderResult result = render(entry, 320, 180);
            answers.insert(measuredPlane(result, info().family));
            json cost = {{"bytes", result.gpuBytes}, {"counters", result.counters}};
            for (const PassCost& pass : result.passes)
                cost["passes"].push_back({pass.name, pass.draws, pass.triangles});
            costs.insert(cost.dump());
        }
        const bool isCost = std::find(costOnly.begin(), costOnly.end(), param.key) != costOnly.end();
        EXPECT_GE(isCost ? costs.size() : answers.size(), 2u) << param.key << " changes nothing";
    }
}

// What the manual and the records give as a default is what a technique has when nobody sets it.
TEST_P(EveryTechnique, DefaultsAreThoseOfItsObjects) {
    const std::unique_ptr<gl::Context> context = gl::Context::createHeadless({});
    context->makeCurrent();
    const std::unique_ptr<Technique> fresh = techniqueEntry(GetParam()).create();
    for (const ParamField& field : fresh->table().fields())
        EXPECT_EQ(field.get(fresh->params()), field.info.defaultValue) << field.info.key;
}

// Every combination of Define parameters (each alone beyond 64 combinations) compiles and leaves no debug message.
TEST_P(EveryTechnique, EveryVariantCompiles) {
    std::vector<std::vector<std::pair<std::string, std::string>>> choices;
    std::size_t combinations = 1;
    for (const ParamInfo& param : info().params) {
        if (param.effect != ParamEffect::Define) continue;
        std::vector<std::pair<std::string, std::string>> values;
        if (param.type == ombrage::ParamType::Enum)
            for (const std::string& choice : param.choices) values.emplace_back(param.key, choice);
        else if (param.type == ombrage::ParamType::Bool)
            values = {{param.key, "false"}, {param.key, "true"}};
        else
            values = {{param.key, toString(ParamValue(std::int64_t(param.minimum)))},
                      {param.key, toString(ParamValue(std::int64_t(param.maximum)))}};
        combinations *= values.size();
        choices.push_back(std::move(values));
    }
    json entry = liveEntry();
    if (combinations <= 64) {
        for (std::size_t c = 0; c < combinations; ++c) {
            entry["params"] = json::object();
            std::size_t rest = c;
            for (const auto& values : choices) {
                entry["params"][values[rest % values.size()].first] = values[rest % values.size()].second;
                rest /= values.size();
            }
            EXPECT_NO_THROW(render(entry, 64, 36)) << entry.dump();
        }
    } else {
        for (const auto& values : choices)
            for (const auto& [key, value] : values) {
                entry["params"] = {{key, value}};
                EXPECT_NO_THROW(render(entry, 64, 36)) << entry.dump();
            }
    }
}

// `noise` is measured where a technique says that it uses random numbers, so what it says must be so.
TEST_P(EveryTechnique, SaysWhetherItUsesTheSeed) {
    const json live = technicalSheet(info()).value("live", json::object());
    std::vector<json> entries{liveEntry()};
    for (const auto& [key, special] : live.items())
        if (special.is_object() && special.contains("scene")) {
            entries.push_back(liveEntry());
            entries.back()["scene"] = special["scene"];
        }
    bool differs = false;
    for (const json& entry : entries) {
        const Bench& bench = Bench::of(entry.at("scene"));
        RenderSettings settings = settingsFor(entry);
        settings.width = kWidth / 2;
        settings.height = kHeight / 2;
        if (info().family == Family::Shadow) settings.light = bench.scene().lights.front().name;
        const std::vector<float> first = measuredPlane(renderScene(bench.scene(), settings), info().family);
        settings.seed += 1;
        differs = differs || measuredPlane(renderScene(bench.scene(), settings), info().family) != first;
    }
    // What a filter is fed with may be random.
    if (info().family != Family::Filter) {
        EXPECT_EQ(differs, info().usesSeed);
    }
}

TEST_P(EveryTechnique, HoldsItsMetamorphicFacts) {
    for (const json& fact : technicalSheet(info()).value("metamorphic", json::array())) {
        const RenderResult result = render(fact);
        const std::vector<float> image = measuredPlane(result, info().family);
        double sum = 0, count = 0;
        for (std::size_t i = 0; i < result.instance.size(); ++i)
            if (result.instance[i] != kNoHit) {
                sum += double(image[i]);
                ++count;
            }
        const std::string expect = fact.at("expect");
        if (expect == "same as default") {
            json plain = fact;
            plain.erase("params");
            const std::vector<float> before = measuredPlane(render(plain), info().family);
            std::size_t differing = 0;
            for (std::size_t i = 0; i < image.size(); ++i) differing += std::abs(image[i] - before[i]) > 0.01f ? 1 : 0;
            // A handful of pixels may lie on an edge that two ways of drawing round differently.
            EXPECT_LE(differing, 5u) << fact.dump();
            continue;
        }
        // "visibility>=0.98" or "visibility<=0.02": the mean over all surfaces.
        ASSERT_EQ(expect.substr(0, 10), "visibility") << expect;
        const double bound = json::parse(expect.substr(12)).get<double>(), mean = sum / count;
        if (expect.substr(10, 2) == ">=")
            EXPECT_GE(mean, bound) << fact.dump();
        else
            EXPECT_LE(mean, bound) << fact.dump();
    }
}

/// Everything turned about the vertical axis by 90 degrees and moved.
Scene turned(Scene scene) {
    const glm::dmat3 turn(0, 0, -1, 0, 1, 0, 1, 0, 0);
    const glm::dvec3 shift(4, 2, -8);
    glm::dmat4 move(turn);
    move[3] = glm::dvec4(shift, 1);
    for (Instance& instance : scene.instances) instance.worldFromLocal = move * instance.worldFromLocal;
    for (Light& light : scene.lights) {
        light.position = turn * light.position + shift;
        light.direction = glm::vec3(turn * glm::dvec3(light.direction));
    }
    for (Camera& camera : scene.cameras) {
        camera.position = turn * camera.position + shift;
        camera.target = turn * camera.target + shift;
    }
    return scene;
}

// Turning and moving scene and camera together changes nothing but rounding. Map texels and noise move with the axes,
// so a technique may state another share of differing pixels than 0.2 % under "invariance".
TEST_P(EveryTechnique, TurningSceneAndCameraChangesNothing) {
    if (info().family != Family::Shadow && info().family != Family::Ao) GTEST_SKIP() << "no visibility of its own";
    json entry = liveEntry();
    const std::vector<float> before = measuredPlane(render(entry), info().family);
    const Scene scene = turned(Bench::of(entry.at("scene")).scene());
    RenderSettings settings = settingsFor(entry);
    if (info().family == Family::Shadow) settings.light = scene.lights.front().name;
    const std::vector<float> after = measuredPlane(renderScene(scene, settings), info().family);
    renderScene(Bench::of(entry.at("scene")).scene(), settings);  // the turned scene ends here
    std::size_t differing = 0;
    for (std::size_t i = 0; i < before.size(); ++i) differing += std::abs(before[i] - after[i]) > 0.1f ? 1 : 0;
    EXPECT_LE(double(differing) / double(before.size()), technicalSheet(info()).value("invariance", 0.002));
}

std::vector<std::string> allIds() {
    std::vector<std::string> ids;
    for (const TechniqueInfo& info : techniques()) ids.push_back(info.id);
    return ids;
}

INSTANTIATE_TEST_SUITE_P(Techniques, EveryTechnique, testing::ValuesIn(allIds()), [](const auto& id) {
    std::string name = id.param;
    for (char& c : name)
        if (!isalnum(static_cast<unsigned char>(c))) c = '_';
    return name;
});

}  // namespace
}  // namespace ombrage::test
