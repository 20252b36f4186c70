// SPDX-License-Identifier: MIT
#include <algorithm>

#include <fmt/format.h>
#include <ombrage/error.h>

#include "core/trace.h"
#include "render/renderer_impl.h"
#include "render/statistics.h"

namespace ombrage {

void Renderer::Impl::forgetEarlierPipelines(const RenderSettings& settings, const RenderRequest& request) {
    // A pipeline that runs no pass never asks for its place: what an earlier call left there would stay, and be
    // counted.
    std::vector<std::string> inUse;
    for (const std::string& place : request.places) {
        const Pipeline& pipeline = place == "ao"         ? settings.ao
                                   : place == "indirect" ? settings.indirect
                                   : place == "aa"       ? settings.aa
                                                         : settings.shadow;
        if (!isNeutral(pipeline)) inUse.push_back(place);
    }
    // Lights that share a place do so as long as nothing changes.
    if (shadowed.sharing > 0 && settings.shadow == earlierPipelines[0]) inUse.emplace_back(kSharedShadow);
    slots.keepOnly(inUse);
    // Else what is about to be replaced would take the room of what replaces it.
    if (settings.shadow != earlierPipelines[0])
        for (const int light : request.lights) slots.release(fmt::format("shadow {}", light));
    const std::array<Pipeline, 4> pipelines{settings.shadow, settings.ao, settings.indirect, settings.aa};
    if (pipelines != earlierPipelines) targets.trim();
    // What was gathered with other random numbers, or from something else, is no history.
    if (pipelines != earlierPipelines || settings.seed != earlierSeed) gatheredFrames = 0;
    earlierSeed = settings.seed;
    earlierPipelines = pipelines;
    // A visibility that is given takes the place of a pipeline's.
    if (!settings.givenVisibility.empty()) earlierPipelines = {};
}

int Renderer::Impl::settlingFrames(const RenderSettings& settings) const {
    int frames = 0;
    for (const Pipeline* pipeline : {&settings.shadow, &settings.ao, &settings.indirect, &settings.aa})
        for (const TechniqueSpec& spec : *pipeline)
            frames = std::max(frames, techniqueEntry(spec.id).traits.settlingFrames);
    return frames;
}

FrameTargets Renderer::Impl::renderFrames(FrameContext& frame, const RenderSettings& settings,
                                          const RenderRequest& request, FrameCosts& costs) {
    FrameTargets produced;
    recorder.timesPasses = settings.timing == Timing::Passes;
    recorder.countsSavings = settings.countSavings && recorder.timesPasses;
    timer->take();
    const int settling = settlingFrames(settings);
    const bool startsHistory = settling > 0 && gatheredFrames == 0;
    if (startsHistory) slots.invalidate();
    const int warmup = startsHistory ? std::max(settings.warmupFrames, settling) : settings.warmupFrames;
    const int frames = warmup + settings.frames;
    for (int i = 0; i < frames; ++i) {
        if (settings.progress && !settings.progress(double(i) / frames))
            throw Error(ErrorCode::Interrupted, "interrupted", fmt::format("after {} of {} frames", i, frames));
        recorder.capturing = i == frames - 1;
        recorder.passes.clear();
        recorder.counters.clear();
        frame.frameIndex = std::uint32_t(settings.firstFrame + i);
        frame.seed = std::uint32_t(settings.seed);
        // Frames that are gathered differ in their random numbers; 2^32 over the golden ratio keeps seeds apart.
        if (settling > 0) frame.seed += 0x9E3779B9u * gatheredFrames++;
        produced = {};
        const TraceScope trace(i < warmup ? "frame (warm-up)" : "frame");
        const double start = threadTime_ms();
        if (!recorder.timesPasses) timer->begin("frame");
        produced = renderFrame(frame, settings, request);
        if (!recorder.timesPasses) timer->end();
        const double cpu = threadTime_ms() - start;

        for (const auto& work : recorder.passes)
            if (std::find(costs.passes.begin(), costs.passes.end(), work.name) == costs.passes.end())
                costs.passes.push_back(work.name);
        // Passes of one name (one per light) count as one row.
        std::map<std::string, double> times;
        double total = 0;
        for (const gl::GpuTimer::Span& span : timer->take()) {
            times[span.name] += span.time_ms;
            total += span.time_ms;
        }
        if (i < warmup) continue;
        for (const auto& [name, time] : times) costs.passes_ms[name].push_back(time);
        costs.totals_ms.push_back(total);
        costs.cpu_ms.push_back(cpu);
    }
    return produced;
}

RenderResult Renderer::Impl::render(const RenderSettings& settings) {
    if (!scene) throw Error(ErrorCode::Usage, "nothing to render", "call setScene first");
    const RenderRequest request = checkRequest(*scene, settings);
    const TraceScope whole("render");
    traceFact("device", device.renderer);
    traceFact("clock", device.clock);

    poseScene(settings.time_s);

    // An error in the middle of the last call may have left anything here.
    recorder.warnings = request.warnings;
    // Shaders of --shader-dir that changed; one that fails to compile keeps its old version and says so.
    for (const std::string& message : shaders->reload()) recorder.warnings.push_back(message);
    recorder.blocks.clear();
    recorder.shown.clear();
    recorder.wanted = std::set<std::string>(settings.show.begin(), settings.show.end());
    recorder.wantsAll = recorder.wanted.count("all") > 0;
    forgetEarlierPipelines(settings, request);

    FrameContext frame;
    {
        const TraceScope trace("prepare targets");
        prepareFrame(frame, settings, request);
    }
    RenderResult result;
    FrameCosts costs;
    const FrameTargets produced = renderFrames(frame, settings, request, costs);
    previousCamera = frame.scene->cameras[std::size_t(request.camera)];

    readBack(result, frame, produced, settings.images || !settings.show.empty());
    for (const std::string& name : costs.passes) {
        const std::vector<double>& times_ms = costs.passes_ms[name];
        PassCost cost{name, statsOf(times_ms), 0, 0, times_ms};
        for (const auto& work : recorder.passes)
            if (work.name == name) {
                cost.draws += work.draws;
                cost.triangles += work.triangles;
                cost.bytes += work.bytes;
            }
        result.passes.push_back(cost);
    }
    result.gpu_ms = statsOf(costs.totals_ms);
    result.frames_ms = costs.totals_ms;
    result.cpu_ms = statsOf(costs.cpu_ms).median;
    result.cpuFrames_ms = costs.cpu_ms;
    if (shadowed.sharing == 0) slots.release(kSharedShadow);
    result.gpuBytes = targets.bytes() + byteSize(*gbuffer) + slots.gpuBytes();
    result.counters = recorder.counters;
    result.footprint = shadowed.footprint;
    result.range = shadowed.range;
    if (shadowed.sharing > 0)
        frame.warn(
            fmt::format("the shadows of {} of {} lights find no room in {} MiB of memory and are drawn anew in "
                        "every frame",
                        shadowed.sharing, request.lights.size(), keptShadowBytes >> 20));
    result.warnings = recorder.warnings;
    result.debugMessages = context->takeDebugMessages();
    recorder.blocks.clear();
    return result;
}

}  // namespace ombrage
