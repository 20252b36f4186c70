// SPDX-License-Identifier: MIT
#include "lab/scene_runner.h"

#include <ombrage/error.h>
#include <ombrage/version.h>

#include "core/hash.h"
#include "lab/pictures.h"

namespace ombrage {

namespace {

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

std::string hashOf(const std::string& text) {
    Hasher hasher;
    hasher.text(text);
    return hasher.hex();
}

RunRecord::Timing timing(const Stats& stats) {
    return {stats.median, stats.p95};
}

}  // namespace

SceneRunner::SceneRunner(const Scene& scene, const CompareRequest& request, Renderer& renderer,
                         std::function<bool(const std::string&)> tell)
    : m_scene(scene),
      m_moved(scene),
      m_request(request),
      m_renderer(renderer),
      m_tell(std::move(tell)),
      m_hash(contentHash(scene)) {
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
    // The hash keeps scenes of one name apart, the size runs of one folder.
    std::string text = fileSlug(m_scene.name) + "-" + m_hash.substr(0, 6) + "-" +
                       fileSlug(m_scene.cameras[std::size_t(m_camera)].name);
    if (light >= 0) text += "-" + fileSlug(m_scene.lights[std::size_t(light)].name);
    return text + "-" + std::to_string(m_request.base.width) + "x" + std::to_string(m_request.base.height);
}

std::string SceneRunner::save(const std::string& name, const std::string& kind, const Image& image) const {
    const std::string path = "images/" + name + "-" + kind + ".png";
    writeImage(m_request.outputDir / path, image);
    return path;
}

RenderSettings SceneRunner::settingsFor(int light) const {
    RenderSettings settings = m_request.base;
    if (light >= 0) settings.light = m_scene.lights[std::size_t(light)].name;
    return settings;
}

SceneRunner::ShadowCase& SceneRunner::shadowCase(int light) {
    if (m_shadow && m_shadow->light == light) return *m_shadow;
    const Receivers& seen = receivers();
    announce(m_scene.name + ": tracing the shadows of the light '" + m_scene.lights[std::size_t(light)].name + "'");
    ShadowCase made;
    made.light = light;
    made.truth = m_reference->shadow(seen, m_moved.cameras[std::size_t(m_camera)], light, referenceOptions());
    // The picture that a perfect technique would give: the same renderer with the truth in the technique's place.
    RenderSettings settings = settingsFor(light);
    settings.frames = 1;
    settings.warmupFrames = 0;
    settings.givenVisibility[light] = greyPicture(made.truth.visibility, made.truth.width, made.truth.height);
    made.picture = displayed(m_renderer.render(settings).picture);
    made.truthPath = save(stem(light), "truth", settings.givenVisibility[light]);
    made.picturePath = save(stem(light), "truth-picture", made.picture);
    m_shadow = std::move(made);
    return *m_shadow;
}

SceneRunner::AoCase& SceneRunner::aoCase() {
    if (m_ao) return *m_ao;
    const Receivers& seen = receivers();
    announce(m_scene.name + ": tracing the ambient occlusion");
    AoCase made;
    made.truth = m_reference->ao(seen, m_moved.cameras[std::size_t(m_camera)], referenceOptions());
    made.truthPath =
        save(stem(-1) + "-ao", "truth", greyPicture(made.truth.visibility, made.truth.width, made.truth.height));
    m_ao = std::move(made);
    return *m_ao;
}

void SceneRunner::measureShadowRun(const PlannedRun& planned, const RenderResult& result, const std::string& name,
                                   RunRecord& record) {
    const ShadowCase& known = shadowCase(planned.light);
    const auto visibility = result.visibility.find(planned.light);
    if (visibility == result.visibility.end())
        throw Error(ErrorCode::Environment, "the renderer gave no visibility for the light '" + record.light + "'");
    const std::span<const float> measured = visibility->second.plane(0);
    // Only where raster and rays see the same triangle can the visibilities be compared.
    ShadowTruth truth = known.truth;
    maskDisagreement(truth.mask, truth.maskedShare, receivers(), result.instance, result.triangle);
    const auto footprint = result.footprint.find(planned.light);
    const ShadowMeasurement measurement = measureShadow(
        measured, truth, receivers(), footprint == result.footprint.end() ? TexelFootprint{} : footprint->second,
        domainMask(planned.pipeline, m_moved.lights[std::size_t(planned.light)], m_traits, receivers()));
    record.metrics = measurement.metrics;
    const Image picture = displayed(result.picture);
    record.metrics["flip"] = meanOf(flip(known.picture, picture));
    record.truth = RunRecord::Truth{"shadow", truth.samplesPerPixel, truth.meanStandardError, truth.maskedShare};
    record.images = {
        {"truth", known.truthPath},
        {"reference", known.picturePath},
        {"picture", save(name, "picture", picture)},
        {"visibility", save(name, "visibility", visibility->second)},
        {"error", save(name, "error", errorPicture(measured, truth.visibility, truth.mask, truth.width, truth.height))},
        {"classes", save(name, "classes", classPicture(measurement.classes, truth.mask, truth.width, truth.height))}};
}

void SceneRunner::measureAoRun(const RenderResult& result, const std::string& name, RunRecord& record) {
    const AoCase& known = aoCase();
    if (!result.ao) throw Error(ErrorCode::Environment, "the renderer gave no ambient visibility");
    const std::span<const float> measured = result.ao->plane(0);
    AoTruth truth = known.truth;
    maskDisagreement(truth.mask, truth.maskedShare, receivers(), result.instance, result.triangle);
    record.metrics = measureAo(measured, truth);
    record.truth = RunRecord::Truth{"T1", truth.samplesPerPixel, truth.meanStandardError, truth.maskedShare};
    record.images = {{"truth", known.truthPath},
                     {"picture", save(name, "picture", displayed(result.picture))},
                     {"visibility", save(name, "visibility", *result.ao)},
                     {"error", save(name, "error",
                                    errorPicture(measured, truth.visibility, truth.mask, truth.width, truth.height))}};
}

RunRecord SceneRunner::describe(const PlannedRun& planned, const RenderSettings& settings,
                                const RenderResult& result) const {
    RunRecord record;
    record.scene = m_scene.name;
    record.sceneHash = m_hash;
    record.camera = m_scene.cameras[std::size_t(m_camera)].name;
    if (planned.light >= 0) record.light = settings.light;
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

RunRecord SceneRunner::run(const PlannedRun& planned) {
    RenderSettings settings = settingsFor(planned.light);
    placeOf(planned.family, settings) = planned.pipeline;
    // The truth comes first, so that the message names what takes the time.
    if (planned.family == Family::Shadow) shadowCase(planned.light);
    if (planned.family == Family::Ao) aoCase();
    const std::string text = toString(planned.pipeline);
    announce(m_scene.name + ": " + text);
    const RenderResult result = m_renderer.render(settings);

    RunRecord record = describe(planned, settings, result);
    // Parameters differ in more than letters and digits: a hash keeps their files apart.
    const std::string technique = techniqueText(planned.pipeline);
    std::string name = stem(planned.light) + "-" + fileSlug(technique);
    if (text != technique) name += "-" + hashOf(text).substr(0, 6);
    if (planned.family == Family::Shadow) {
        measureShadowRun(planned, result, name, record);
    } else if (planned.family == Family::Ao) {
        measureAoRun(result, name, record);
    } else {
        record.images["picture"] = save(name, "picture", displayed(result.picture));
    }
    return record;
}

}  // namespace ombrage
