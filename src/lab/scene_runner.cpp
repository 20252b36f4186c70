// SPDX-License-Identifier: MIT
#include "lab/scene_runner.h"

#include <algorithm>

#include <ombrage/displace.h>
#include <ombrage/error.h>
#include <ombrage/version.h>

#include "core/whole_file.h"
#include "lab/pictures.h"

namespace ombrage {

namespace {

RunRecord::Timing timing(const Stats& stats) {
    return {stats.median, stats.p95};
}

}  // namespace

SceneRunner::SceneRunner(const Scene& scene, const CompareRequest& request, const CompareKeys& keys, Renderer& renderer,
                         std::function<bool(const std::string&)> tell)
    : m_scene(scene), m_moved(scene), m_request(request), m_keys(keys), m_renderer(renderer), m_tell(std::move(tell)) {
    animate(m_moved, request.base.time_s);
    m_camera = m_moved.cameraIndex(request.base.camera);
    m_traits = sceneTraits(m_moved);
    m_renderer.setScene(m_scene);
}

ReferenceOptions SceneRunner::referenceOptions() const {
    ReferenceOptions options;
    options.width = m_request.base.width;
    options.height = m_request.base.height;
    options.samplesPerPixel = m_request.truthSamples;
    options.seed = m_request.base.seed;
    options.progress = [this](double) { return m_tell({}); };
    return options;
}

void SceneRunner::announce(const std::string& what) const {
    if (!m_tell(what)) throw Error(ErrorCode::Interrupted, "interrupted", "what was done is kept");
}

const Receivers& SceneRunner::receivers() {
    if (!m_receivers) {
        m_reference = std::make_unique<Reference>(m_moved);
        m_receivers = m_reference->receivers(m_moved.cameras[std::size_t(m_camera)], referenceOptions());
    }
    return *m_receivers;
}

std::string SceneRunner::stem(int light) const {
    std::string text = fileSlug(m_scene.name) + "-" + fileSlug(m_scene.cameras[std::size_t(m_camera)].name);
    if (light >= 0) text += "-" + fileSlug(m_scene.lights[std::size_t(light)].name);
    return text + "-" + std::to_string(m_request.base.width) + "x" + std::to_string(m_request.base.height);
}

std::string SceneRunner::fileName(const PlannedRun& planned, std::optional<TruthKind> kind) const {
    return stem(planned.light) + "-" + fileSlug(techniqueText(planned.pipeline)) + "-" +
           m_keys.record(planned, kind).hash();
}

std::string SceneRunner::truthName(int light, TruthKind kind, const std::string& claimed) const {
    return stem(light) + "-" + fileSlug(truthKindName(kind)) + "-" + m_keys.truth(light, kind, claimed).hash();
}

std::string SceneRunner::save(const std::string& name, const std::string& kind, const Image& image) const {
    if (m_only) return {};
    const std::string path = "images/" + name + "-" + kind + ".png";
    writeWhole(m_request.outputDir / path, [&](const std::filesystem::path& part) { writeImage(part, image); });
    return path;
}

RenderSettings SceneRunner::settingsFor(int light) const {
    RenderSettings settings = m_request.base;
    settings.countSavings = true;
    if (light >= 0) settings.light = m_scene.lights[std::size_t(light)].name;
    return settings;
}

Image SceneRunner::supersampled(RenderSettings settings) {
    settings.width *= kAreaGrid;
    settings.height *= kAreaGrid;
    settings.frames = 1;
    settings.warmupFrames = 0;
    settings.aa = RenderSettings{}.aa;
    return displayed(averagedOverPixels(m_renderer.render(settings).picture, kAreaGrid));
}

SceneRunner::ShadowCase& SceneRunner::shadowCase(int light, TruthKind kind) {
    if (m_shadow && m_shadow->light == light && m_shadow->kind == kind) return *m_shadow;
    const Receivers& seen = receivers();
    announce(m_scene.name + ": tracing the shadows of the light '" + m_scene.lights[std::size_t(light)].name + "'");
    const Camera& camera = m_moved.cameras[std::size_t(m_camera)];
    ReferenceOptions options = referenceOptions();
    options.kind = kind;
    ShadowCase made;
    made.light = light;
    made.kind = kind;
    // The picture that a perfect technique would give: the same renderer with the truth in the technique's place.
    RenderSettings settings = settingsFor(light);
    settings.frames = 1;
    settings.warmupFrames = 0;
    if (kind == TruthKind::Area) {
        Image fine = Image::grey(options.width * kAreaGrid, options.height * kAreaGrid);
        made.truth = m_reference->areaShadow(camera, light, options, [&](int part, const ShadowTruth& truth) {
            spreadOverPixels(truth.visibility, truth.width, part, kAreaGrid, fine);
        });
        settings.givenVisibility[light] = std::move(fine);
        made.picture = supersampled(settings);
    } else {
        made.truth = m_reference->shadow(seen, camera, light, options);
        made.features = m_reference->shadowFeatures(seen, light, options);
        settings.givenVisibility[light] = greyPicture(made.truth.visibility, made.truth.width, made.truth.height);
        if (wants("flip")) made.picture = displayed(m_renderer.render(settings).picture);
    }
    const std::string name = truthName(light, kind, "");
    made.truthPath = save(name, "truth", greyPicture(made.truth.visibility, made.truth.width, made.truth.height));
    if (wants("flip")) made.picturePath = save(name, "truth-picture", made.picture);
    m_shadow = std::move(made);
    return *m_shadow;
}

SceneRunner::AoCase& SceneRunner::aoCase(TruthKind kind, const Pipeline& pipeline) {
    // What is claimed depends on the technique's parameters, not on what filters it afterwards.
    const std::string claimed = kind == TruthKind::Own ? toString({pipeline.front()}) : "";
    for (AoCase& known : m_ao)
        if (known.kind == kind && known.pipeline == claimed) return known;
    const Receivers& seen = receivers();
    announce(m_scene.name + ": tracing the ambient occlusion" +
             (claimed.empty() ? "" : " that " + claimed + " claims"));
    const Camera& camera = m_moved.cameras[std::size_t(m_camera)];
    ReferenceOptions options = referenceOptions();
    options.kind = kind;
    const std::unique_ptr<AoIntegrand> integrand = kind == TruthKind::Own ? ownIntegrand(pipeline) : nullptr;
    options.integrand = integrand.get();
    AoCase made;
    made.kind = kind;
    made.pipeline = claimed;
    if (kind == TruthKind::Displaced) {
        const Scene traced = displaced(m_moved);
        const Reference reference(traced);
        options.kind = TruthKind::T1;
        made.receivers = reference.receivers(camera, options);
        made.truth = reference.ao(*made.receivers, camera, options);
    } else {
        made.truth =
            kind == TruthKind::Area ? m_reference->areaAo(camera, options) : m_reference->ao(seen, camera, options);
    }
    made.truthPath = save(truthName(-1, kind, claimed), "truth",
                          greyPicture(made.truth.visibility, made.truth.width, made.truth.height));
    m_ao.push_back(std::move(made));
    return m_ao.back();
}

void SceneRunner::measureShadowRun(const Measured& run, RunRecord& record) {
    const int light = run.planned.light;
    const ShadowCase& known = shadowCase(light, run.kind);
    const auto visibility = run.result.visibility.find(light);
    if (visibility == run.result.visibility.end())
        throw Error(ErrorCode::Environment, "the renderer gave no visibility for the light '" + record.light + "'");
    const std::span<const float> measured = visibility->second.plane(0);
    // Only where raster and rays see the same triangle can the visibilities be compared; a mean over the pixel has
    // many.
    ShadowTruth truth = known.truth;
    if (run.kind != TruthKind::Area)
        maskDisagreement(truth.mask, truth.maskedShare, receivers(), run.result.instance, run.result.triangle);
    ShadowQuestion question;
    if (const auto texels = run.result.footprint.find(light); texels != run.result.footprint.end()) {
        question.footprint = texels->second;
        if (question.footprint.texel_m > 0) record.counters["texel [m]"] = question.footprint.texel_m;
        if (question.footprint.texelPerMetre > 0)
            record.counters["texel per metre from the light"] = question.footprint.texelPerMetre;
    }
    if (const auto range = run.result.range.find(light); range != run.result.range.end())
        question.inRange =
            inRange(range->second, m_reference->positions(receivers()), m_moved.cameras[std::size_t(m_camera)]);
    question.inDomain = domainMask(run.planned.pipeline, m_moved.lights[std::size_t(light)], m_traits, receivers());
    question.features = known.features ? &*known.features : nullptr;
    const ShadowMeasurement measurement = measureShadow(measured, truth, receivers(), question);
    record.metrics = measurement.metrics;
    if (wants("noise"))
        record.metrics["noise"] = measureNoise(
            run, truth.mask, [&](const RenderResult& result) { return result.visibility.at(light).plane(0); });
    const Image picture = displayed(run.result.picture);
    if (wants("flip")) record.metrics["flip"] = meanOf(flip(known.picture, picture));
    record.truth =
        RunRecord::Truth{truthKindName(run.kind), truth.samplesPerPixel, truth.meanStandardError, truth.maskedShare};
    record.images = {{"truth", known.truthPath},
                     {"reference", known.picturePath},
                     {"picture", save(run.name, "picture", picture)},
                     {"visibility", save(run.name, "visibility", visibility->second)},
                     {"error", save(run.name, "error",
                                    errorPicture(measured, truth.visibility, truth.mask, truth.width, truth.height))}};
    if (run.kind == TruthKind::Area) {
        // Edges and causes are questions to points; a mean over the pixel has neither.
        for (const MetricInfo& info : metricInfos())
            if (info.ofPoints) record.metrics.erase(info.key);
    } else {
        record.images["classes"] =
            save(run.name, "classes",
                 classPicture(measurement.classes, truth.visibility, truth.mask, truth.width, truth.height));
    }
}

void SceneRunner::measureAoRun(const Measured& run, RunRecord& record) {
    const AoCase& known = aoCase(run.kind, run.planned.pipeline);
    if (!run.result.ao) throw Error(ErrorCode::Environment, "the renderer gave no ambient visibility");
    const std::span<const float> measured = run.result.ao->plane(0);
    AoTruth truth = known.truth;
    if (known.receivers)
        maskDisagreement(truth.mask, truth.maskedShare, *known.receivers, run.result.instance, {});
    else if (run.kind != TruthKind::Area)
        maskDisagreement(truth.mask, truth.maskedShare, receivers(), run.result.instance, run.result.triangle);
    record.metrics = measureAo(measured, truth);
    if (wants("noise"))
        record.metrics["noise"] =
            measureNoise(run, truth.mask, [](const RenderResult& result) { return result.ao->plane(0); });
    record.truth =
        RunRecord::Truth{truthKindName(run.kind), truth.samplesPerPixel, truth.meanStandardError, truth.maskedShare};
    record.images = {{"truth", known.truthPath},
                     {"picture", save(run.name, "picture", displayed(run.result.picture))},
                     {"visibility", save(run.name, "visibility", *run.result.ao)},
                     {"error", save(run.name, "error",
                                    errorPicture(measured, truth.visibility, truth.mask, truth.width, truth.height))}};
}

std::optional<double> SceneRunner::measureNoise(
    const Measured& run, const std::vector<Mask>& mask,
    const std::function<std::span<const float>(const RenderResult&)>& planeOf) {
    const bool isValid = std::find(mask.begin(), mask.end(), Mask::Valid) != mask.end();
    const Pipeline& pipeline = run.planned.pipeline;
    if (!isValid) return std::nullopt;
    if (std::none_of(pipeline.begin(), pipeline.end(),
                     [](const TechniqueSpec& spec) { return technique(spec.id).usesSeed; }))
        return 0.0;
    RenderSettings settings = run.settings;
    settings.frames = 1;
    settings.warmupFrames = 0;
    std::vector<std::vector<float>> pictures;
    const auto keep = [&](const RenderResult& result) {
        const std::span<const float> plane = planeOf(result);
        pictures.emplace_back(plane.begin(), plane.end());
    };
    keep(run.result);
    while (pictures.size() < std::size_t(kNoiseSeeds)) {
        announce({});
        ++settings.seed;
        keep(m_renderer.render(settings));
        // A hard light, or a pattern that is switched off: other seeds change nothing either.
        if (pictures.back() == pictures.front()) return 0.0;
    }
    return noiseOf(pictures, mask);
}

void SceneRunner::measureAaRun(const Measured& run, RunRecord& record) {
    const Image reference = supersampled(settingsFor(-1)), picture = displayed(run.result.picture);
    record.metrics["flip"] = meanOf(flip(reference, picture));
    record.truth = RunRecord::Truth{truthKindName(run.kind), kAreaGrid * kAreaGrid, 0, 0};
    record.images = {{"reference", save(truthName(-1, run.kind, ""), "truth-picture", reference)},
                     {"picture", save(run.name, "picture", picture)}};
}

RunRecord SceneRunner::describe(const PlannedRun& planned, const RenderSettings& settings,
                                const RenderResult& result) const {
    RunRecord record;
    record.scene = m_scene.name;
    record.sceneHash = m_keys.sceneHash();
    record.camera = m_scene.cameras[std::size_t(m_camera)].name;
    if (planned.light >= 0) record.light = settings.light;
    record.time_s = settings.time_s;
    record.normals = normalSourceName(settings.normals);
    record.width = settings.width;
    record.height = settings.height;
    record.family = familyName(planned.family);
    record.technique = techniqueText(planned.pipeline);
    record.pipeline = toString(planned.pipeline);
    for (const TechniqueSpec& spec : planned.pipeline)
        for (auto& [key, value] : resolveParams(spec))
            record.params.emplace_back(planned.pipeline.size() == 1 ? key : spec.id + "." + key, std::move(value));
    for (const PassCost& pass : result.passes)
        record.passes.push_back({pass.name, timing(pass.gpu_ms), pass.draws, pass.triangles});
    record.gpu_ms = timing(result.gpu_ms);
    record.frames_ms = result.frames_ms;
    record.cpu_ms = result.cpu_ms;
    record.gpuBytes = result.gpuBytes;
    record.counters = result.counters;
    record.seed = settings.seed;
    record.version = versionString();
    const DeviceInfo& device = m_renderer.device();
    record.clock = device.clock;
    record.device = {device.renderer, device.version, device.software};
    record.warnings = result.warnings;
    record.warnings.insert(record.warnings.end(), m_scene.warnings.begin(), m_scene.warnings.end());
    return record;
}

std::vector<RunRecord> SceneRunner::run(const PlannedRun& planned) {
    if (planned.motion) return {runMotion(planned)};
    RenderSettings settings = settingsFor(planned.light);
    placeOf(planned.family, settings) = planned.pipeline;
    // The truth comes first, so that the message names what takes the time.
    for (const TruthKind kind : planned.truths) {
        if (planned.family == Family::Shadow) shadowCase(planned.light, kind);
        if (planned.family == Family::Ao) aoCase(kind, planned.pipeline);
    }
    announce(m_scene.name + ": " + toString(planned.pipeline));
    const RenderResult result = m_renderer.render(settings);

    std::vector<RunRecord> records;
    for (const TruthKind kind : planned.truths) {
        records.push_back(describe(planned, settings, result));
        const Measured run{planned, settings, result, kind, fileName(planned, kind)};
        if (planned.family == Family::Shadow)
            measureShadowRun(run, records.back());
        else if (planned.family == Family::Ao)
            measureAoRun(run, records.back());
        else
            measureAaRun(run, records.back());
    }
    if (planned.truths.empty()) {
        records.push_back(describe(planned, settings, result));
        records.back().images["picture"] = save(fileName(planned, std::nullopt), "picture", displayed(result.picture));
    }
    if (m_only)
        for (RunRecord& record : records) record.images.clear();
    return records;
}

}  // namespace ombrage
