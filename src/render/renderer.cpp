// SPDX-License-Identifier: MIT
#include <ombrage/renderer.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include <fmt/format.h>
#include <ombrage/error.h>

#include "core/log.h"
#include "core/trace.h"
#include "gl/context.h"
#include "gl/program_cache.h"
#include "render/composer.h"
#include "render/geometry_pass.h"
#include "render/recorder.h"
#include "render/request.h"
#include "render/standard_views.h"
#include "render/statistics.h"
#include "render/technique_slots.h"

namespace ombrage {

/// Textures that a frame leaves behind, for reading back.
struct FrameTargets {
    std::map<int, TargetPool::Target> visibility;
    TargetPool::Target ao, indirect, color;
};

struct Renderer::Impl {
    std::unique_ptr<gl::Context> context;
    DeviceInfo device;
    std::unique_ptr<gl::GpuTimer> timer;
    std::unique_ptr<gl::ProgramCache> programs;
    std::unique_ptr<gl::ShaderLibrary> shaders;

    // Everything below holds GL objects and dies before the context, in reverse order.
    TargetPool targets;
    FrameContext::Recorder recorder;
    std::unique_ptr<GpuScene> gpuScene;
    const Scene* scene = nullptr;
    Scene posed;                       ///< the scene at the requested time, when it is animated
    const Scene* posedFrom = nullptr;  ///< what `posed` is but for what moves
    std::unique_ptr<GBuffer> gbuffer;
    GeometryPass geometry;
    Composer composer;
    TechniqueSlots slots;
    std::optional<Camera> previousCamera;
    std::vector<glm::dmat4> placements;        ///< of the instances in gpuScene
    std::array<Pipeline, 4> earlierPipelines;  ///< of the last call: shadow, ao, indirect, aa
    const std::uint64_t keptShadowBytes;

    /// What the shadow techniques of the frame just rendered say of it, per light index.
    struct Shadowed {
        std::map<int, TexelFootprint> footprint;
        std::map<int, ShadowRange> range;
        std::uint64_t keptBytes = 0, largestBytes = 0;  ///< of all lights with techniques of their own, and of one
        std::size_t sharing = 0;                        ///< lights that found no room
    } shadowed;

    Impl(std::unique_ptr<gl::Context> made, const RendererOptions& options);
    ~Impl();

    void upload(const Scene& next);
    void moveScene(const Scene& next);
    void show(const Scene& next);
    void poseScene(double time_s);
    void prepareFrame(FrameContext& frame, const RenderSettings& settings, const RenderRequest& request);
    FrameTargets renderFrame(FrameContext& frame, const RenderSettings& settings, const RenderRequest& request);
    LitLight renderShadow(FrameContext& frame, const RenderSettings& settings, const LightFrame& light);
    void noteShadow(const LightFrame& light, const ShadowTechnique& technique);
    std::string shadowPlace(const LightFrame& light);
    TargetPool::Target renderAo(FrameContext& frame, const Pipeline& pipeline);
    TargetPool::Target applyFilter(FrameContext& frame, Technique& filter, const TargetPool::Target& input);
    /// Frees what only earlier calls used, so that what a call costs does not depend on them.
    void forgetEarlierPipelines(const RenderSettings& settings, const RenderRequest& request);
    void readBackImages(RenderResult& result, const FrameTargets& produced);
    void readBack(RenderResult& result, const FrameContext& frame, const FrameTargets& produced, bool images);
    RenderResult render(const RenderSettings& settings);
};

namespace {

/// The place of the techniques of all lights that find no room for their own.
constexpr const char* kSharedShadow = "shadow of the rest";

/// Whether the pipeline changes nothing, so that no pass need run for it.
bool isNeutral(const Pipeline& pipeline) {
    return pipeline.size() == 1 && pipeline[0].params.empty() && techniqueEntry(pipeline[0].id).traits.neutral;
}

/// Whether lighting may ask the shadow technique itself, as nobody wants its image.
bool mayLookUp(const RenderSettings& settings) {
    return !settings.images && settings.show.empty() && settings.composite == Composite::Lighting &&
           settings.shadow.size() == 1 && techniqueEntry(settings.shadow[0].id).answersAnywhere;
}

/// What a pipeline that changes nothing leaves: visibility 1.
Image allOpen(const GBuffer& gbuffer) {
    Image image = Image::grey(gbuffer.layout.width, gbuffer.layout.height, "visibility");
    std::fill(image.plane(0).begin(), image.plane(0).end(), 1.0f);
    return image;
}

std::vector<glm::dmat4> placementsOf(const Scene& scene) {
    std::vector<glm::dmat4> placements;
    for (const Instance& instance : scene.instances) placements.push_back(instance.worldFromLocal);
    return placements;
}

/// Whether `b` can be `a` with its parts elsewhere. Their triangles are not looked at.
bool hasSameParts(const Scene& a, const Scene& b) {
    const auto counts = [](const Scene& s) {
        return std::array{s.meshes.size(), s.materials.size(), s.textures.size(),
                          s.models.size(), s.lights.size(),    s.cameras.size()};
    };
    return counts(a) == counts(b) &&
           std::equal(a.instances.begin(), a.instances.end(), b.instances.begin(), b.instances.end(),
                      [](const Instance& x, const Instance& y) { return x.mesh == y.mesh && x.model == y.model; });
}

/// @throws Error(Usage) for a shader directory without a single shader: a wrong path would silently change nothing.
const std::string& checkedShaderDir(const std::string& directory) {
    if (directory.empty()) return directory;
    const std::filesystem::path root(directory);
    const auto paths = gl::ShaderLibrary::embeddedPaths();
    const bool hasShaders =
        std::filesystem::is_directory(root / "render/glsl") ||
        std::any_of(paths.begin(), paths.end(), [&](const auto& path) { return std::filesystem::exists(root / path); });
    if (!hasShaders)
        throw Error(ErrorCode::Usage, fmt::format("the shader directory '{}' holds no shader", directory),
                    fmt::format("files lie in it by their paths, such as {}", paths.front()));
    return directory;
}

}  // namespace

Renderer::Impl::Impl(std::unique_ptr<gl::Context> made, const RendererOptions& options)
    : context(std::move(made)),
      timer(std::make_unique<gl::GpuTimer>()),
      programs(std::make_unique<gl::ProgramCache>(options.cache)),
      shaders(std::make_unique<gl::ShaderLibrary>(checkedShaderDir(options.shaderDir), programs.get())),
      keptShadowBytes(options.keptShadowBytes) {
    device = {context->renderer(), context->vendor(), context->version(), context->isSoftware(),
              gl::clockName(timer->clock())};
    recorder.timer = timer.get();
    for (const std::string& warning : context->warnings()) warn(warning);
}

Renderer::Impl::~Impl() {
    context->makeCurrent();
}

void Renderer::Impl::upload(const Scene& next) {
    gpuScene = std::make_unique<GpuScene>(next);
    placements = placementsOf(next);
}

void Renderer::Impl::moveScene(const Scene& next) {
    if (!scene) throw Error(ErrorCode::Usage, "no scene to move", "call setScene first");
    if (!hasSameParts(*scene, next))
        throw Error(ErrorCode::Usage, "the scene '" + next.name + "' has other parts than the one to be moved",
                    "call setScene for another scene");
    scene = &next;
    show(next);
}

/// The same parts where `next` has them: geometry goes up again only when instances moved.
void Renderer::Impl::show(const Scene& next) {
    if (placements == placementsOf(next)) {
        gpuScene->follow(next);
        return;
    }
    upload(next);
    slots.sceneMoved();
}

void Renderer::Impl::poseScene(double time_s) {
    const bool isAnimated = !scene->animations.empty() && time_s != 0;
    if (!isAnimated) {
        if (&gpuScene->scene() != scene) show(*scene);
        return;
    }
    const TraceScope trace("animate");
    if (posedFrom != scene) posed = *scene;
    posedFrom = scene;
    posed.cameras = scene->cameras;
    posed.lights = scene->lights;
    posed.instances = scene->instances;
    animate(posed, time_s);
    show(posed);
}

void Renderer::Impl::prepareFrame(FrameContext& frame, const RenderSettings& settings, const RenderRequest& request) {
    const GBufferLayout layout{settings.width, settings.height, request.needsStencil,
                               request.needsMaterial || gpuScene->hasSpecular()};
    if (!gbuffer || gbuffer->layout != layout) {
        gbuffer = GeometryPass::makeGBuffer(layout);
        targets.trim();
        slots.invalidate();
    }
    frame.width = settings.width;
    frame.height = settings.height;
    frame.scene = &gpuScene->scene();
    frame.gpuScene = gpuScene.get();
    frame.gbuffer = gbuffer.get();
    const auto viewOf = [&](const Camera& camera) {
        return makeCameraView(camera, settings.width, settings.height, gpuScene->origin(), gpuScene->bounds());
    };
    frame.view = viewOf(frame.scene->cameras[std::size_t(request.camera)]);
    frame.fitView = settings.fitCamera ? viewOf(*settings.fitCamera) : frame.view;
    frame.previousView = previousCamera ? viewOf(*previousCamera) : frame.view;
    frame.normals = settings.normals;
    frame.shaders = shaders.get();
    frame.targets = &targets;
    frame.recorder = &recorder;
}

TargetPool::Target Renderer::Impl::applyFilter(FrameContext& frame, Technique& filter,
                                               const TargetPool::Target& input) {
    auto output = targets.take(input->desc(), "filtered");
    static_cast<FilterTechnique&>(filter).render(frame, *input, *output);
    return output;
}

void Renderer::Impl::noteShadow(const LightFrame& light, const ShadowTechnique& technique) {
    if (technique.refinesInput()) return;
    shadowed.footprint[light.index] = technique.footprint();
    shadowed.range[light.index] = technique.range();
}

std::string Renderer::Impl::shadowPlace(const LightFrame& light) {
    const std::string own = fmt::format("shadow {}", light.index);
    if (slots.has(own) || shadowed.keptBytes + shadowed.largestBytes <= keptShadowBytes) return own;
    // What finds no room shares one place, whose textures are used again rather than freed and made: allocators give
    // large blocks back late or never.
    ++shadowed.sharing;
    slots.invalidate(kSharedShadow);
    return kSharedShadow;
}

LitLight Renderer::Impl::renderShadow(FrameContext& frame, const RenderSettings& settings, const LightFrame& light) {
    const auto given = settings.givenVisibility.find(light.index);
    const bool isGiven = given != settings.givenVisibility.end();
    if (!isGiven && isNeutral(settings.shadow)) {
        shadowed.footprint[light.index] = {};
        shadowed.range[light.index] = {};
        return {light, nullptr};
    }
    const std::string place = isGiven ? "" : shadowPlace(light);
    const bool isOwn = place != kSharedShadow;
    const auto countBytes = [&, before = slots.gpuBytes(place)] {
        if (!isOwn) return;
        const std::uint64_t after = slots.gpuBytes(place);
        shadowed.keptBytes += after - before;
        shadowed.largestBytes = std::max(shadowed.largestBytes, after);
    };
    // Lighting looks up later, when a shared place holds another light's.
    if (!isGiven && isOwn && mayLookUp(settings)) {
        composer.bindLight(light, gpuScene->flat().instances.size());
        auto& technique = static_cast<ShadowLookupTechnique&>(*slots.get(place, settings.shadow, frame).front());
        const ShadowLookup lookup = technique.lookup(frame, light);
        noteShadow(light, technique);
        countBytes();
        return {light, nullptr, &technique, lookup};
    }
    auto visibility = targets.take({.format = GL_R16F, .width = frame.width, .height = frame.height}, "visibility");
    if (isGiven) {
        uploadPlane(*visibility, given->second.plane(0));
        return {light, visibility};
    }
    {
        const auto pass = frame.pass("clear visibility");
        const gl::Framebuffer target({{visibility.get()}}, {}, "visibility");
        target.bind();
        gl::apply({});
        target.clearColor(0, glm::vec4(1.0f));
    }
    composer.bindLight(light, gpuScene->flat().instances.size());
    TargetPool::Target colored;
    for (const auto& technique : slots.get(place, settings.shadow, frame)) {
        if (colored)
            frame.warn(fmt::format("{} does not keep the colours of the shadow before it", technique->entry().id()));
        colored = nullptr;
        if (technique->entry().family == Family::Shadow) {
            auto& shadow = static_cast<ShadowTechnique&>(*technique);
            shadow.render(frame, light, *visibility);
            colored = shadow.takeColored();
            noteShadow(light, shadow);
        } else {
            visibility = applyFilter(frame, *technique, visibility);
        }
    }
    countBytes();
    LitLight lit{light, visibility};
    lit.colored = colored;
    return lit;
}

TargetPool::Target Renderer::Impl::renderAo(FrameContext& frame, const Pipeline& pipeline) {
    if (isNeutral(pipeline)) return nullptr;
    auto visibility = targets.take({.format = GL_R16F, .width = frame.width, .height = frame.height}, "ao");
    bool first = true;
    for (const auto& technique : slots.get("ao", pipeline, frame)) {
        if (technique->entry().family == Family::Ao)
            static_cast<AoTechnique&>(*technique).render(frame, *visibility);
        else
            visibility = applyFilter(frame, *technique, visibility);
        if (first && pipeline.size() > 1 && frame.wants("ao-unfiltered"))
            frame.expose("ao-unfiltered", *visibility, ShowAs::Value);
        first = false;
    }
    return visibility;
}

FrameTargets Renderer::Impl::renderFrame(FrameContext& frame, const RenderSettings& settings,
                                         const RenderRequest& request) {
    FrameTargets produced;
    gl::beginFrameState();
    geometry.uploadFrameBlock(frame);
    geometry.draw(frame);

    shadowed = {};
    for (const int index : request.lights) {
        const std::uint64_t bytes = slots.gpuBytes(fmt::format("shadow {}", index));
        shadowed.keptBytes += bytes;
        shadowed.largestBytes = std::max(shadowed.largestBytes, bytes);
    }
    std::vector<LitLight> lights;
    for (int index : request.lights) {
        LightFrame light{index, &frame.scene->lights[std::size_t(index)]};
        light.position = glm::vec3(light.light->position - gpuScene->origin());
        light.direction = light.light->direction;
        const FrameContext::LightScope scope(frame, light, index == request.lights.front());
        lights.push_back(renderShadow(frame, settings, light));
        produced.visibility[index] = lights.back().visibility;
    }
    produced.ao = renderAo(frame, settings.ao);

    if (!isNeutral(settings.indirect)) {
        produced.indirect =
            targets.take({.format = GL_RGBA16F, .width = frame.width, .height = frame.height}, "indirect");
        for (const auto& technique : slots.get("indirect", settings.indirect, frame))
            static_cast<IndirectTechnique&>(*technique).render(frame, *produced.indirect);
    }

    produced.color = composer.compose(frame, settings, lights, produced.ao, produced.indirect);
    if (isNeutral(settings.aa)) return produced;
    for (const auto& technique : slots.get("aa", settings.aa, frame)) {
        auto output = targets.take(produced.color->desc(), "anti-aliased");
        static_cast<AaTechnique&>(*technique).render(frame, *produced.color, *output);
        produced.color = output;
    }
    return produced;
}

void Renderer::Impl::readBackImages(RenderResult& result, const FrameTargets& produced) {
    for (const auto& [index, texture] : produced.visibility)
        result.visibility[index] = texture ? readColor(*texture, {"visibility"}, ColorSpace::Data) : allOpen(*gbuffer);
    result.ao = produced.ao ? readColor(*produced.ao, {"visibility"}, ColorSpace::Data) : allOpen(*gbuffer);
    readIds(*gbuffer, gpuScene->flat(), result.instance, result.triangle);
}

void Renderer::Impl::readBack(RenderResult& result, const FrameContext& frame, const FrameTargets& produced,
                              bool images) {
    const TraceScope trace("read back");
    result.picture = readColor(*produced.color, {"R", "G", "B"}, ColorSpace::Linear);
    if (!images) return;
    readBackImages(result, produced);

    auto& shown = recorder.shown;
    const auto offer = [&](const std::string& name, auto&& make) {
        if (recorder.wantsAll || recorder.wanted.count(name) > 0) shown[name] = make();
    };
    offer("final", [&] { return ShownImage{result.picture, result.picture}; });
    offer("visibility", [&] {
        const Image& first = result.visibility.empty() ? *result.ao : result.visibility.begin()->second;
        return ShownImage{first, first};
    });
    for (const auto& [index, image] : result.visibility)
        if (index != result.visibility.begin()->first)
            offer("visibility@" + frame.scene->lights[std::size_t(index)].name, [&shownImage = image] {
                return ShownImage{shownImage, shownImage};
            });
    offer("ao", [&] { return ShownImage{*result.ao, *result.ao}; });
    offer("indirect", [&] {
        if (produced.indirect) return showTexture(*produced.indirect, ShowAs::Color);
        const Image black = Image::rgb(gbuffer->layout.width, gbuffer->layout.height);
        return ShownImage{black, black};
    });
    for (const PassInfo& view : standardGBufferViews())
        offer(view.name, [&] { return showGBuffer(view.name, *gbuffer, frame.view, gpuScene->flat()); });
    for (auto& [name, image] : shown) {
        result.shown[name] = std::move(image.display);
        result.shownRaw[name] = std::move(image.raw);
    }
}

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
    earlierPipelines = pipelines;
    // A visibility that is given takes the place of a pipeline's.
    if (!settings.givenVisibility.empty()) earlierPipelines = {};
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
    FrameTargets produced;
    std::vector<double> totals, cpuTimes;
    std::vector<std::string> order;
    std::map<std::string, std::vector<double>> passTimes;
    recorder.timesPasses = settings.timing == Timing::Passes;
    recorder.countsSavings = settings.countSavings && recorder.timesPasses;
    timer->take();
    const int frames = settings.warmupFrames + settings.frames;
    for (int i = 0; i < frames; ++i) {
        if (settings.progress && !settings.progress(double(i) / frames))
            throw Error(ErrorCode::Interrupted, "interrupted", fmt::format("after {} of {} frames", i, frames));
        recorder.capturing = i == frames - 1;
        recorder.passes.clear();
        recorder.counters.clear();
        frame.frameIndex = std::uint32_t(settings.firstFrame + i);
        frame.seed = std::uint32_t(settings.seed);
        produced = {};
        const TraceScope trace(i < settings.warmupFrames ? "frame (warm-up)" : "frame");
        const double start = threadTime_ms();
        if (!recorder.timesPasses) timer->begin("frame");
        produced = renderFrame(frame, settings, request);
        if (!recorder.timesPasses) timer->end();
        const double cpu = threadTime_ms() - start;

        for (const auto& work : recorder.passes)
            if (std::find(order.begin(), order.end(), work.name) == order.end()) order.push_back(work.name);
        // Passes of one name (one per light) count as one row.
        std::map<std::string, double> times;
        double total = 0;
        for (const gl::GpuTimer::Span& span : timer->take()) {
            times[span.name] += span.time_ms;
            total += span.time_ms;
        }
        if (i < settings.warmupFrames) continue;
        for (const auto& [name, time] : times) passTimes[name].push_back(time);
        totals.push_back(total);
        cpuTimes.push_back(cpu);
    }
    previousCamera = frame.scene->cameras[std::size_t(request.camera)];

    readBack(result, frame, produced, settings.images || !settings.show.empty());
    for (const std::string& name : order) {
        PassCost cost{name, statsOf(passTimes[name]), 0, 0, passTimes[name]};
        for (const auto& work : recorder.passes)
            if (work.name == name) {
                cost.draws += work.draws;
                cost.triangles += work.triangles;
                cost.bytes += work.bytes;
            }
        result.passes.push_back(cost);
    }
    result.gpu_ms = statsOf(totals);
    result.frames_ms = totals;
    result.cpu_ms = statsOf(cpuTimes).median;
    result.cpuFrames_ms = cpuTimes;
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

Renderer::Renderer(const RendererOptions& options) {
    const TraceScope trace("start OpenGL");
    auto context = gl::Context::createHeadless({options.device, options.debugContext});
    m_impl = std::make_unique<Impl>(std::move(context), options);
}

Renderer::Renderer(AdoptCurrent, const RendererOptions& options) {
    auto context = gl::Context::adoptCurrent();
    const gl::StateGuard guard;
    m_impl = std::make_unique<Impl>(std::move(context), options);
}

Renderer::~Renderer() = default;

void Renderer::setScene(const Scene& scene) {
    m_impl->context->makeCurrent();
    std::optional<gl::StateGuard> guard;
    if (m_impl->context->isAdopted()) guard.emplace();
    const TraceScope trace("set scene");
    m_impl->scene = &scene;
    m_impl->posedFrom = nullptr;
    m_impl->slots.clear();
    m_impl->upload(scene);
    m_impl->previousCamera.reset();
    m_impl->earlierPipelines = {};
    m_impl->slots.invalidate();
}

void Renderer::moveScene(const Scene& scene) {
    m_impl->context->makeCurrent();
    std::optional<gl::StateGuard> guard;
    if (m_impl->context->isAdopted()) guard.emplace();
    const TraceScope trace("move scene");
    m_impl->moveScene(scene);
}

RenderResult Renderer::render(const RenderSettings& settings) {
    m_impl->context->makeCurrent();
    std::optional<gl::StateGuard> guard;
    if (m_impl->context->isAdopted()) guard.emplace();
    return m_impl->render(settings);
}

const DeviceInfo& Renderer::device() const {
    return m_impl->device;
}

std::vector<PassInfo> Renderer::showNames(const RenderSettings& settings) const {
    return showNamesOf(settings);
}

}  // namespace ombrage
