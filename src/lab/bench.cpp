// SPDX-License-Identifier: MIT
#include <ombrage/bench.h>
#include <ombrage/error.h>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "lab/bench_baseline.h"
#include "lab/bench_json.h"
#include "lab/bench_plan.h"
#include "lab/plan.h"
#include "lab/program_identity.h"
#include "lab/spheres.h"
#include "lab/statistics.h"
#include "lab/store.h"
#include "lab/turns.h"

namespace ombrage {

namespace {

/// Rounds when there are frames enough for at least two in each.
constexpr int kRounds = 25;
/// Frames with every pass timed by itself: where that finishes the queue it says what share each has, not what it
/// costs.
constexpr int kPassFrames = 10;

BenchFigures figuresOf(std::vector<double> samples) {
    return {medianOf(samples), p95Of(samples), madOf(samples), std::move(samples)};
}

/// Measures one scene at one point with all of its pipelines.
class GroupBench {
public:
    GroupBench(const BenchRequest& request, const BenchResult& result, Renderer& renderer,
               std::function<bool(const std::string&, double)> tell)
        : m_request(request), m_result(result), m_renderer(renderer), m_tell(std::move(tell)) {}

    void run(const std::vector<BenchVariant>& variants, BenchGroup& group) {
        std::vector<RenderSettings> settings;
        for (const BenchVariant& variant : variants) {
            settings.push_back(m_request.base);
            settings.back().width = group.width;
            settings.back().height = group.height;
            placeOf(variant.family, settings.back()) = variant.pipeline;
            settings.back().progress = [this](double) { return m_tell("", 0); };
        }
        // Shaders compile, caches fill, the machine's clock speeds up.
        group.runs.resize(variants.size());
        for (std::size_t i = 0; i < variants.size(); ++i) {
            say(group.scene + ": warming up " + variants[i].label, 0);
            RenderResult drawn;
            drawFrames(m_renderer, settings[i], m_request.warmupFrames, &drawn);
            group.runs[i].pipeline = toString(variants[i].pipeline);
            group.runs[i].label = variants[i].label;
            group.runs[i].gpuBytes = drawn.gpuBytes;
            group.runs[i].counters = drawn.counters;
        }
        std::vector<Subject> subjects;
        for (const RenderSettings& s : settings)
            subjects.push_back([&](int frames) { return drawFrames(m_renderer, s, frames); });
        const TurnPlan plan{m_result.rounds, m_result.framesPerRound,
                            m_result.decidedBy == "gpu_ms" ? &FrameCosts::gpu_ms : &FrameCosts::process_ms,
                            m_request.base.seed};
        // How often again is not known: each time goes half of the way that is left.
        const auto costs = takeTurnsUntilClear(subjects, plan, [&](int round) {
            const double times = double(round + 1) / m_result.rounds;
            say(group.scene + ": timing frames by turns", 0.9 * (1 - std::exp2(-times)));
        });
        for (std::size_t i = 0; i < variants.size(); ++i) {
            group.runs[i].gpu_ms = figuresOf(costs[i].gpu_ms);
            group.runs[i].process_ms = figuresOf(costs[i].process_ms);
            group.runs[i].cpu_ms = figuresOf(costs[i].cpu_ms);
            say(group.scene + ": timing the passes of " + variants[i].label, 0.95);
            timePasses(settings[i], group.runs[i]);
        }
        for (std::size_t i = 1; i < variants.size(); ++i) compareToFirst(group, i);
    }

private:
    void say(const std::string& what, double share) const {
        if (!m_tell(what, share)) throw Error(ErrorCode::Interrupted, "interrupted", "what was done is kept");
    }

    void timePasses(RenderSettings settings, BenchRun& run) const {
        settings.timing = Timing::Passes;
        settings.warmupFrames = 1;
        settings.frames = kPassFrames;
        for (const PassCost& pass : m_renderer.render(settings).passes) {
            // What the warm-up alone did, a cached map, is no cost of a frame.
            if (pass.frames_ms.empty()) continue;
            run.passes.push_back({pass.name, figuresOf(pass.frames_ms), pass.draws, pass.triangles, pass.bytes});
            run.draws += pass.draws;
            run.triangles += pass.triangles;
        }
    }

    void compareToFirst(BenchGroup& group, std::size_t run) const {
        const auto costs = [&](const BenchRun& of) {
            return costsOfRounds(decidingFigures(m_result, of).samples, m_result.framesPerRound);
        };
        const Difference d = pairedDifference(costs(group.runs[0]), costs(group.runs[run]), m_request.base.seed);
        group.runs[run].toFirst = BenchDifference{d.change, d.low, d.high, verdictName(d.verdict)};
    }

    const BenchRequest& m_request;
    const BenchResult& m_result;
    Renderer& m_renderer;
    std::function<bool(const std::string&, double)> m_tell;
};

/// Times have no truth to be checked against: whatever could have changed them is in the key.
ResultKey keyOf(const BenchGroup& group, const std::vector<BenchVariant>& variants, const BenchRequest& request,
                const BenchResult& result, const std::string& program) {
    const RenderSettings& base = request.base;
    ResultKey key(kBenchKind);
    key.add("scene", group.scene).add("scene_hash", group.sceneHash).add("camera", group.camera);
    key.add("light", group.light).add("width", group.width).add("height", group.height);
    key.add("time_s", base.time_s).add("seed", base.seed).add("axis", group.axis).add("value", group.value);
    key.add("normals", int(base.normals)).add("shading", int(base.shading)).add("ambient", int(base.ambient));
    key.add("composite", int(base.composite)).add("overlay_opacity", base.overlayOpacity);
    for (const Pipeline* place : {&base.shadow, &base.ao, &base.indirect, &base.aa})
        key.add("beside", toString(*place));
    std::string pipelines;
    for (const BenchVariant& variant : variants) pipelines += variant.label + " = " + toString(variant.pipeline) + "\n";
    key.add("pipelines", pipelines).add("warmup_frames", request.warmupFrames);
    key.add("rounds", result.rounds).add("frames_per_round", result.framesPerRound);
    key.add("renderer", result.device.renderer).add("driver", result.device.version);
    // A stored time must have been taken by the clock that the result names.
    return key.add("clock", result.device.clock).add("program", program);
}

/// Before anything is measured for nothing.
void checkBaseline(const BenchResult& baseline, const std::vector<BenchVariant>& variants) {
    for (const BenchGroup& group : baseline.groups)
        for (const BenchRun& run : group.runs)
            for (const BenchVariant& variant : variants)
                if (variant.label == run.label) return;
    throw noCommonRun();
}

void checkRequest(const BenchRequest& request) {
    if (request.scenes.empty() && !request.sweep)
        throw Error(ErrorCode::Usage, "no scene to measure on", "'ombrage list scenes' shows the built-in ones");
    if (request.pipelines.empty() && request.allOf.empty())
        throw Error(ErrorCode::Usage, "no technique to measure", "use --technique ID or --all FAMILY");
    if (request.frames < int(kFewestRounds))
        throw Error(ErrorCode::Usage, "too few frames to say anything of a difference",
                    "measure at least " + std::to_string(kFewestRounds));
    if (request.warmupFrames < 1)
        throw Error(ErrorCode::Usage, "without a warm-up the first frames measure the compiler",
                    "warm up at least once");
    if (request.failAbove && request.baseline.empty())
        throw Error(ErrorCode::Usage, "nothing to be slower than", "name a --baseline");
}

}  // namespace

BenchResult bench(const BenchRequest& request, const RendererOptions& options) {
    checkRequest(request);
    const std::vector<BenchPoint> points = benchPoints(request);
    std::optional<BenchResult> baseline;
    if (!request.baseline.empty()) baseline = readBench(request.baseline);
    std::vector<Scene> scenes;
    for (const std::string& name : eachOnce(request.scenes)) scenes.push_back(loadScene(name, request.sceneOptions));

    BenchResult result;
    result.commandLine = request.commandLine;
    result.rounds = request.frames >= 2 * kRounds ? kRounds : request.frames;
    result.framesPerRound = request.frames / result.rounds;
    // Wrong names and values come out before the first frame.
    for (const Scene& scene : scenes)
        for (const BenchPoint& point : points) {
            std::vector<SkippedPair> ignored;
            scene.cameraIndex(request.base.camera);
            const std::vector<BenchVariant> variants = benchVariants(request, scene, point, ignored);
            if (baseline) checkBaseline(*baseline, variants);
        }

    std::optional<ResultStore> store;
    if (!request.outputDir.empty()) {
        makeResultFolder(request.outputDir);
        store.emplace(request.outputDir);
    }
    const double groupCount = double(points.size() * std::max<std::size_t>(scenes.size(), 1));
    std::string what;
    double done = 0, inGroup = 0;
    // An empty text is a sign of life between two messages.
    const auto tell = [&](const std::string& text, double share) {
        if (!text.empty()) {
            what = text;
            inGroup = share;
        }
        return !request.progress || request.progress(what, (done + inGroup) / groupCount);
    };
    try {
        if (!tell("starting OpenGL", 0)) throw Error(ErrorCode::Interrupted, "interrupted");
        Renderer renderer(options);
        result.device = renderer.device();
        result.decidedBy = result.device.software ? "process_ms" : "gpu_ms";
        if (baseline) requireSameDevice(result, *baseline);
        const std::string program = programIdentity(options.shaderDir);
        const auto measure = [&](const Scene& scene, const BenchPoint& point) {
            BenchGroup group;
            group.scene = scene.name;
            group.sceneHash = contentHash(scene);
            group.camera = scene.cameras[std::size_t(scene.cameraIndex(request.base.camera))].name;
            group.light = request.base.light;
            group.width = point.width;
            group.height = point.height;
            if (request.sweep) group.axis = request.sweep->axis;
            group.value = point.value;
            group.x = group.axis == "triangles" ? double(scene.triangleCount()) : point.x;
            std::vector<SkippedPair> skipped;
            const std::vector<BenchVariant> variants = benchVariants(request, scene, point, skipped);
            for (const SkippedPair& pair : skipped)
                if (std::none_of(result.skipped.begin(), result.skipped.end(), [&](const SkippedPair& known) {
                        return known.scene == pair.scene && known.technique == pair.technique;
                    }))
                    result.skipped.push_back(pair);
            const ResultKey key = keyOf(group, variants, request, result, program);
            if (const auto found = store && !request.again ? store->find(key) : std::nullopt) {
                group = benchGroupFromJson(nlohmann::ordered_json::parse(*found));
                ++result.reused;
            } else if (!variants.empty()) {
                renderer.setScene(scene);
                GroupBench(request, result, renderer, tell).run(variants, group);
                if (store) {
                    // Alone in a folder a group must say what its differences are of.
                    nlohmann::ordered_json json = benchGroupJson(group);
                    json["decided_by"] = result.decidedBy;
                    store->put(key, json.dump(), {});
                    store->exportLines();
                }
            }
            if (!group.runs.empty()) result.groups.push_back(std::move(group));
            ++done;
        };
        for (const BenchPoint& point : points) {
            if (point.triangles > 0) measure(spheresScene(point.triangles, point.lights), point);
            for (const Scene& scene : scenes) measure(scene, point);
        }
    } catch (const Error& error) {
        if (error.code() != ErrorCode::Interrupted) throw;
        result.interrupted = true;
    }
    if (baseline) holdAgainst(result, *baseline, request.failAbove, request.base.seed);
    return result;
}

}  // namespace ombrage
