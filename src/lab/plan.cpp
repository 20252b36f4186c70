// SPDX-License-Identifier: MIT
#include "lab/plan.h"

#include <ombrage/error.h>
#include <algorithm>
#include <limits>

#include "core/strings.h"
#include "lab/domain.h"
#include "lab/motion.h"

namespace ombrage {

namespace {

bool meantFor(const Scene& scene, const TechniqueSpec& spec) {
    return scene.techniques.empty() ||
           std::find(scene.techniques.begin(), scene.techniques.end(), spec.id) != scene.techniques.end();
}

/// What feeds a filter under `--all filter`.
Pipeline filterInput() {
    const std::string baseline = RenderSettings{}.ao.front().id;
    for (const TechniqueInfo& info : techniques())
        if (info.family == Family::Ao && info.id != baseline) return {{info.id, {}}};
    return {{baseline, {}}};
}

}  // namespace

Pipeline& placeOf(Family family, RenderSettings& settings) {
    switch (family) {
        case Family::Shadow:
            return settings.shadow;
        case Family::Indirect:
            return settings.indirect;
        case Family::Aa:
            return settings.aa;
        case Family::Ao:
        case Family::Filter:
            break;
    }
    return settings.ao;
}

std::vector<int> chosenLights(const Scene& scene, const std::string& name) {
    if (!name.empty()) return {scene.lightIndex(name)};
    std::vector<int> lights(scene.lights.size());
    for (std::size_t i = 0; i < lights.size(); ++i) lights[i] = int(i);
    return lights;
}

std::string techniqueText(const Pipeline& pipeline) {
    std::vector<std::string> ids;
    for (const TechniqueSpec& spec : pipeline) ids.push_back(spec.id);
    return join(ids, "+");
}

std::vector<std::pair<Family, Pipeline>> pipelinesOf(Family family) {
    std::vector<std::pair<Family, Pipeline>> result;
    for (const TechniqueInfo& info : techniques()) {
        if (info.family != family) continue;
        Pipeline pipeline;
        if (family == Family::Filter) pipeline = filterInput();
        pipeline.push_back({info.id, {}});
        result.emplace_back(family == Family::Filter ? Family::Ao : family, std::move(pipeline));
    }
    return result;
}

std::vector<TruthKind> truthsOf(const CompareRequest& request, Family family, const Pipeline& pipeline,
                                std::string& reason) {
    const bool claims = family == Family::Ao && ownIntegrand(pipeline) != nullptr;
    if (request.truthKind.empty()) {
        if (family == Family::Shadow) return {TruthKind::Shadow};
        if (family != Family::Ao) return {};
        return claims ? std::vector{TruthKind::T1, TruthKind::Own} : std::vector{TruthKind::T1};
    }
    const TruthKind kind = truthKindFromName(request.truthKind);
    std::vector<TruthKind> fitting;
    if (family == Family::Shadow) fitting = truthKindsOf(Quantity::Shadow);
    if (family == Family::Ao) fitting = truthKindsOf(Quantity::Ao);
    if (family == Family::Aa) fitting = {TruthKind::Area};
    if (std::find(fitting.begin(), fitting.end(), kind) == fitting.end())
        reason = "the truth '" + request.truthKind + "' does not fit " + techniqueText(pipeline);
    else if (kind == TruthKind::Own && !claims)
        reason = pipeline.front().id + " claims no integral that the truth 'own' could trace";
    if (!reason.empty()) return {};
    return {kind};
}

std::string motionMisfit(const Motion& motion, Family family, TruthKind kind) {
    const std::string name = "the motion '" + motion.script.name + "'";
    if (family != Family::Shadow && family != Family::Ao)
        return name + " is measured for shadows and ambient occlusion alone";
    if (family == Family::Ao && motion.movesLight()) return name + " changes nothing of ambient occlusion";
    if (kind == TruthKind::Area || kind == TruthKind::Own || kind == TruthKind::Displaced)
        return name + " has no truth of the kind '" + truthKindName(kind) + "'";
    return {};
}

namespace {

/// The plan's runs once more under each script, by light and script so that truths are shared.
void addMotions(ScenePlan& plan, const Scene& scene, const std::vector<Motion>& motions) {
    const std::vector<PlannedRun> still = plan.runs;
    std::vector<std::string> known;
    for (const Motion& motion : motions) {
        if (std::find(known.begin(), known.end(), toString(motion)) != known.end()) continue;
        known.push_back(toString(motion));
        // A scene without such a caster has nothing to measure; a wrong name is an error.
        std::string noCaster;
        if (motion.movesCaster() && motion.caster.empty()) try {
                chosenCaster(scene, "");
            } catch (const Error& error) {
                noCaster = error.message();
            }
        else if (motion.movesCaster())
            chosenCaster(scene, motion.caster);
        for (const PlannedRun& run : still) {
            const TruthKind kind = run.truths.empty() ? TruthKind::Area : run.truths.front();
            std::string reason = motionMisfit(motion, run.family, kind);
            if (reason.empty()) reason = noCaster;
            if (!reason.empty())
                plan.skipped.push_back({scene.name, techniqueText(run.pipeline), reason});
            else
                plan.runs.push_back({run.family, run.pipeline, run.light, {kind}, motion});
        }
    }
    // A light at a time, its still pictures first; -1 comes last, as it did.
    const auto place = [](const PlannedRun& run) {
        return run.light < 0 ? std::numeric_limits<int>::max() : run.light;
    };
    std::stable_sort(plan.runs.begin(), plan.runs.end(),
                     [&](const PlannedRun& a, const PlannedRun& b) { return place(a) < place(b); });
}

}  // namespace

ScenePlan planScene(const Scene& scene, const CompareRequest& request) {
    ScenePlan plan;
    const std::vector<int> lights = chosenLights(scene, request.base.light);
    const auto plannedAlready = [&](const Pipeline& pipeline, int light) {
        return std::any_of(plan.runs.begin(), plan.runs.end(),
                           [&](const PlannedRun& run) { return run.light == light && run.pipeline == pipeline; });
    };
    // One pipeline on one light, or on all of them at once (-1).
    const auto add = [&](Family family, const Pipeline& pipeline, int light, bool named) {
        if (light >= 0) {
            const std::string reason = unsupportedReason(pipeline, scene.lights[std::size_t(light)]);
            if (!reason.empty() && named)
                throw Error(ErrorCode::Usage, reason + " of the scene '" + scene.name + "'",
                            "choose another light with --light or another technique");
            if (!reason.empty()) {
                plan.skipped.push_back({scene.name, techniqueText(pipeline), reason});
                return;
            }
        }
        std::string misfit;
        const std::vector<TruthKind> truths = truthsOf(request, family, pipeline, misfit);
        if (!misfit.empty()) {
            if (named)
                throw Error(
                    ErrorCode::Usage, misfit,
                    "shadows are held against shadow, self or area, ambient occlusion against T1 to T5, T5-ball, "
                    "own, displaced or area, anti-aliasing against area");
            plan.skipped.push_back({scene.name, techniqueText(pipeline), misfit});
            return;
        }
        for (const TechniqueSpec& spec : pipeline)
            if (named && !meantFor(scene, spec))
                plan.warnings.push_back("the scene '" + scene.name + "' is not meant for " + spec.id + ", but for " +
                                        join(scene.techniques, ", "));
        if (!plannedAlready(pipeline, light)) plan.runs.push_back({family, pipeline, light, truths});
    };
    const auto addAll = [&](int light, bool wantShadow) {
        for (const auto& [family, pipeline] : request.pipelines)
            if ((family == Family::Shadow) == wantShadow) add(family, pipeline, light, true);
        for (Family all : request.allOf)
            for (const auto& [family, pipeline] : pipelinesOf(all))
                if ((family == Family::Shadow) == wantShadow) add(family, pipeline, light, false);
    };
    for (int light : lights) addAll(light, true);
    addAll(-1, false);
    addMotions(plan, scene, request.motions);
    // Several lights repeat a scene's warning.
    std::sort(plan.warnings.begin(), plan.warnings.end());
    plan.warnings.erase(std::unique(plan.warnings.begin(), plan.warnings.end()), plan.warnings.end());
    return plan;
}

std::vector<std::string> eachOnce(const std::vector<std::string>& texts) {
    std::vector<std::string> result;
    for (const std::string& text : texts)
        if (std::find(result.begin(), result.end(), text) == result.end()) result.push_back(text);
    return result;
}

}  // namespace ombrage
