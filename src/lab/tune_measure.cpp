// SPDX-License-Identifier: MIT
#include "lab/tune_measure.h"

#include <ombrage/error.h>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <system_error>

#include "lab/program_identity.h"
#include "lab/statistics.h"
#include "lab/tune_cases.h"
#include "lab/turns.h"

namespace ombrage::tuning {

namespace {

/// By turns with the start: as many rounds as an interval needs, of few frames.
constexpr int kRounds = 9, kFramesPerRound = 2;
constexpr double kMiB = 1024.0 * 1024;

}  // namespace

const MetricInfo& metricOf(const std::string& key) {
    std::vector<std::string> keys;
    for (const MetricInfo& info : metricInfos()) {
        if (info.key == key) return info;
        keys.push_back(info.key);
    }
    throw unknownName("metric", key, keys);
}

double errorOf(const MetricInfo& metric, double value) {
    return metric.lowerIsBetter ? std::abs(value) : -value;
}

Measurer::Measurer(const TuneRequest& request, const RendererOptions& options,
                   std::function<bool(const std::string&)> tell)
    : m_request(request), m_options(options), m_tell(std::move(tell)) {
    std::vector<std::string> names, cameras;
    for (const std::string& name : eachOnce(request.scenes)) {
        m_scenes.push_back({loadScene(name, request.sceneOptions), 1, nullptr});
        SceneUnit& unit = m_scenes.back();
        names.push_back(unit.scene.name);
        for (const Camera& camera : unit.scene.cameras) cameras.push_back(camera.name);
        if (const auto weight = request.weights.find(unit.scene.name); weight != request.weights.end())
            unit.weight = weight->second;
        addCases(unit);
    }
    for (const auto& [name, weight] : request.weights)
        if (std::find(names.begin(), names.end(), name) == names.end())
            throw unknownName("scene in --weight", name, names);
    for (const std::string& camera : request.holdout)
        if (std::find(cameras.begin(), cameras.end(), camera) == cameras.end())
            throw unknownName("camera to hold out", camera, cameras);

    makeResultFolder(request.outputDir);
    m_store.emplace(request.outputDir);
    say("starting OpenGL");
    m_program = programIdentity(options.shaderDir);
    for (SceneUnit& scene : m_scenes) {
        scene.renderer = std::make_unique<Renderer>(options);
        m_device = scene.renderer->device();
    }
    for (CaseUnit& unit : m_cases)
        unit.keys = std::make_unique<CompareKeys>(unit.scene->scene, unit.request, m_device, m_program);
}

void Measurer::addCases(SceneUnit& unit) {
    const Cameras cameras = divideCameras(unit.scene, m_request.base.camera, m_request.holdout);
    const auto add = [&](const std::string& camera, bool heldOut) {
        CompareRequest compare;
        compare.base = m_request.base;
        compare.base.camera = camera;
        compare.base.frames = 1;
        compare.base.warmupFrames = 0;
        compare.pipelines = {m_request.technique};
        compare.truthSamples = m_request.truthSamples;
        compare.truthKind = m_request.truthKind;
        // Against what a technique claims itself, the search would change the question.
        if (compare.truthKind.empty() && m_request.technique.first == Family::Ao) compare.truthKind = "T1";
        if (compare.truthKind.empty() && m_request.technique.first == Family::Aa) compare.truthKind = "area";
        compare.outputDir = m_request.outputDir;
        for (const PlannedRun& planned : planScene(unit.scene, compare).runs) {
            if (planned.truths.size() != 1 || planned.truths.front() == TruthKind::Own)
                throw Error(ErrorCode::Usage, "'" + toString(planned.pipeline) + "' cannot be tuned against this truth",
                            "a truth that does not depend on the parameters is needed: shadow, T1, area ...");
            m_cases.push_back({&unit, compare, planned, heldOut, nullptr, nullptr});
            const std::string light = planned.light < 0 ? "" : unit.scene.lights[std::size_t(planned.light)].name;
            if (planned.light >= 0) m_cases.back().request.base.light = light;
            m_told.push_back({unit.scene.name, camera, light, heldOut,
                              std::count(cameras.made.begin(), cameras.made.end(), camera) > 0});
        }
    };
    for (const std::string& camera : cameras.searched) add(camera, false);
    for (const std::string& camera : cameras.heldOut) add(camera, true);
}

void Measurer::say(const std::string& what) const {
    if (!m_tell(what)) throw Error(ErrorCode::Interrupted, "interrupted", "what was measured is kept");
}

Renderer& Measurer::rendererOf(CaseUnit& unit) {
    Renderer& renderer = *unit.scene->renderer;
    if (!unit.runner) {
        // One for each case, as one keeps the truth of a single light; all cases of a scene share the renderer.
        unit.runner = std::make_unique<SceneRunner>(
            unit.scene->scene, unit.request, *unit.keys, renderer,
            [this](const std::string& what) { return m_tell(what.rfind(": tracing") == what.npos ? "" : what); });
        unit.runner->measureOnly(m_request.metric);
    }
    return renderer;
}

RenderSettings Measurer::settingsOf(const CaseUnit& unit, const Pipeline& pipeline) const {
    RenderSettings settings = unit.request.base;
    placeOf(unit.planned.family, settings) = pipeline;
    settings.progress = [this](double) { return m_tell(""); };
    return settings;
}

std::optional<std::string> Measurer::find(const ResultKey& key) const {
    return m_request.again && !m_fresh.count(key.text()) ? std::nullopt : m_store->find(key);
}

void Measurer::put(const ResultKey& key, const std::string& record) {
    m_store->put(key, record, {});
    m_fresh.insert(key.text());
}

RunRecord Measurer::recordOf(CaseUnit& unit, const Pipeline& pipeline) {
    PlannedRun planned = unit.planned;
    planned.pipeline = pipeline;
    ResultKey key(kTuneKind);
    key.add("of", unit.keys->record(planned, planned.truths.front()).text()).add("metric", m_request.metric);
    if (const auto found = find(key)) {
        ++m_reused;
        return RunRecord::fromJson(*found, ResultStore::fileIn(m_request.outputDir).string());
    }
    rendererOf(unit);
    RunRecord record = unit.runner->run(planned).front();
    put(key, record.toJson());
    ++m_measured;
    return record;
}

Measurer::Times Measurer::timesOf(CaseUnit& unit, const Pipeline& pipeline) {
    PlannedRun planned = unit.planned;
    planned.pipeline = pipeline;
    ResultKey key("tune-time");
    key.add("of", unit.keys->record(planned, std::nullopt).text()).add("start", toString(m_request.technique.second));
    key.add("rounds", kRounds).add("frames", kFramesPerRound).add("clock", m_device.clock);
    if (const auto found = find(key)) {
        const auto json = nlohmann::json::parse(*found);
        return {json["ratio"].get<double>(), json["time_ms"].get<double>()};
    }
    const Pipeline& start = m_request.technique.second;
    const bool isStart = toString(pipeline) == toString(start);
    Renderer& renderer = rendererOf(unit);
    const RenderSettings settings = settingsOf(unit, pipeline), first = settingsOf(unit, start);
    Times times;
    if (isStart) {
        drawFrames(renderer, first, kFramesPerRound);  // shaders compile
        times.time_ms = medianOf(drawFrames(renderer, first, kRounds * kFramesPerRound).gpu_ms);
    } else {
        const Times known = timesOf(unit, start);
        const auto deciding = m_device.software ? &FrameCosts::process_ms : &FrameCosts::gpu_ms;
        drawFrames(renderer, settings, 1);
        const auto costs = takeTurns({[&](int frames) { return drawFrames(renderer, first, frames); },
                                      [&](int frames) { return drawFrames(renderer, settings, frames); }},
                                     kRounds, kFramesPerRound, m_request.base.seed, [&](int) { say(""); });
        times.ratio = 1 + pairedDifference(costsOfRounds(costs[0].*deciding, kFramesPerRound),
                                           costsOfRounds(costs[1].*deciding, kFramesPerRound), m_request.base.seed)
                              .change;
        times.time_ms = known.time_ms * times.ratio;
    }
    put(key, nlohmann::json{{"ratio", times.ratio}, {"time_ms", times.time_ms}}.dump());
    return times;
}

TuneFigures Measurer::measure(const Pipeline& pipeline, bool heldOut, bool timed) {
    TuneFigures figures;
    double sum = 0, weights = 0;
    for (SceneUnit& scene : m_scenes) {
        // A scene's weight is its own, however many cameras and lights it has.
        double ofScene = 0;
        int count = 0;
        for (CaseUnit& unit : m_cases) {
            if (unit.scene != &scene || unit.isHeldOut != heldOut) continue;
            say(scene.scene.name + ", " + unit.request.base.camera + ": " + toString(pipeline));
            const RunRecord record = recordOf(unit, pipeline);
            const auto metric = record.metrics.find(m_request.metric);
            if (metric == record.metrics.end())
                throw Error(ErrorCode::Usage, "'" + m_request.metric + "' is not measured of " + record.technique,
                            "choose another --metric; docs/user/metrics.md tells what each is of");
            figures.memory_MiB = std::max(figures.memory_MiB, double(record.gpuBytes) / kMiB);
            if (timed) figures.time_ms = std::max(figures.time_ms.value_or(0), timesOf(unit, pipeline).time_ms);
            // Nothing to be measured there, whatever the parameters.
            if (!metric->second) continue;
            ofScene += *metric->second;
            ++count;
        }
        if (count == 0) continue;
        sum += scene.weight * ofScene / count;
        weights += scene.weight;
    }
    if (weights == 0)
        throw Error(ErrorCode::Usage, "no pixel of any scene says anything of '" + m_request.metric + "'",
                    "choose another --metric or other scenes");
    figures.error = sum / weights;
    return figures;
}

}  // namespace ombrage::tuning
