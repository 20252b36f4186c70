// SPDX-License-Identifier: MIT
#include <algorithm>

#include <ombrage/error.h>

#include "lab/pictures.h"
#include "lab/scene_runner.h"
#include "lab/statistics.h"

namespace ombrage {

namespace {

/// Frames before the first of a script: what gathers over frames is past its start then.
constexpr int kWarmupFrames = 8;

/// Times of the frames in which something moves: what the update costs, not what a cache saves.
struct MovedFrames {
    std::vector<double> gpu_ms, cpu_ms;
    std::optional<RenderResult> first;

    void add(RenderResult result) {
        gpu_ms.push_back(result.gpu_ms.median);
        cpu_ms.push_back(result.cpu_ms);
        if (!first) first = std::move(result);
    }
};

MotionShot shotOf(const RenderResult& result, int light) {
    const Image* image = nullptr;
    if (light < 0)
        image = result.ao ? &*result.ao : nullptr;
    else if (const auto found = result.visibility.find(light); found != result.visibility.end())
        image = &found->second;
    if (!image) throw Error(ErrorCode::Environment, "the renderer gave no visibility to measure");
    const auto plane = image->plane(0);
    return {{plane.begin(), plane.end()}, result.instance, result.triangle};
}

}  // namespace

RunRecord SceneRunner::runMotion(const PlannedRun& planned) {
    const MotionScript& script = planned.motion->script;
    if (!m_stage) m_stage = std::make_unique<MotionStage>(m_moved, m_camera, referenceOptions());
    announce(m_scene.name + ": " + toString(planned.pipeline) + " under " + toString(*planned.motion));
    m_stage->ask(
        {*planned.motion, planned.family, planned.truths.front(), planned.light, isScreenSpace(planned.pipeline)});
    RenderSettings settings = settingsFor(planned.light);
    placeOf(planned.family, settings) = planned.pipeline;
    settings.time_s = 0;  // the stage stands at that time already
    settings.frames = 1;

    MovedFrames moved;
    int sequence = 0;
    const MotionMeasurement measured = measureMotion(*m_stage, [&](int frame, bool isFirst) {
        announce({});
        sequence += isFirst ? 1 : 0;
        if (isFirst)
            m_renderer.setScene(m_stage->scene());
        else
            m_renderer.moveScene(m_stage->scene());
        settings.fitCamera = m_stage->fitCamera();
        settings.warmupFrames = isFirst ? kWarmupFrames : 0;
        settings.firstFrame = isFirst ? 0 : kWarmupFrames + frame;
        RenderResult result = m_renderer.render(settings);
        MotionShot shot = shotOf(result, planned.light);
        // In the second sequence all stands still from its start.
        const bool moves = sequence == 1 && (script.jumpAt > 0 ? frame == script.jumpAt : frame > 0);
        if (moves) moved.add(std::move(result));
        return shot;
    });
    m_renderer.setScene(m_scene);

    const RenderResult& result = *moved.first;
    RunRecord record = describe(planned, settings, result);
    record.motion = toString(*planned.motion);
    record.gpu_ms = {medianOf(moved.gpu_ms), p95Of(moved.gpu_ms)};
    record.cpu_ms = medianOf(moved.cpu_ms);
    record.metrics = measured.metrics;
    record.truth = RunRecord::Truth{truthKindName(planned.truths.front()), measured.samplesPerPixel,
                                    measured.standardError, measured.maskedShare};
    if (!measured.settled)
        record.warnings.push_back("the answer had not settled when the script ended; lag is the number of its frames");
    const int width = settings.width, height = settings.height;
    const std::vector<float> still(measured.largest.size(), 0.0f);
    record.images = {{"flicker", save(fileName(planned, planned.truths.front()), "flicker",
                                      errorPicture(measured.largest, still, measured.mask, width, height))}};
    return record;
}

}  // namespace ombrage
