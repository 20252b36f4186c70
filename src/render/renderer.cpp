// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <ombrage/error.h>

#include "core/log.h"
#include "core/trace.h"
#include "render/renderer_impl.h"

namespace ombrage {

const char* normalSourceName(NormalSource source) {
    switch (source) {
        case NormalSource::Geometry:
            return "geometry";
        case NormalSource::Bump:
            return "bump";
        case NormalSource::Map:
            return "map";
    }
    return "";
}

namespace {

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
