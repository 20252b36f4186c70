// SPDX-License-Identifier: MIT
#include <algorithm>

#include <fmt/format.h>
#include <ombrage/error.h>

#include "render/renderer_impl.h"

namespace ombrage {

namespace {

/// Whether lighting may ask the shadow technique itself, as nobody wants its image.
bool mayLookUp(const RenderSettings& settings) {
    return !settings.images && settings.show.empty() && settings.composite == Composite::Lighting &&
           settings.shadow.size() == 1 && techniqueEntry(settings.shadow[0].id).answersAnywhere;
}

}  // namespace

bool isNeutral(const Pipeline& pipeline) {
    return pipeline.size() == 1 && pipeline[0].params.empty() && techniqueEntry(pipeline[0].id).traits.neutral;
}

void Renderer::Impl::prepareFrame(FrameContext& frame, const RenderSettings& settings, const RenderRequest& request) {
    const GBufferLayout layout{settings.width, settings.height, request.samples, request.needsStencil,
                               request.needsMaterial || gpuScene->hasSpecular()};
    if (!gbuffer || gbuffer->layout != layout) {
        gbuffer = GeometryPass::makeGBuffer(layout);
        targets.trim();
        slots.invalidate();
        gatheredFrames = 0;
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
    frame.centredView = frame.view;
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
    // Samples of a pixel that show several surfaces take their visibility from pixels around.
    if (!isGiven && isOwn && !gbuffer->samples && mayLookUp(settings)) {
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
    const std::vector<glm::vec2> centre{glm::vec2(0.0f)};
    std::vector<glm::vec2> points = centre;
    frame.view = frame.centredView;
    if (!isNeutral(settings.aa)) {
        const auto& techniques = slots.get("aa", settings.aa, frame);
        for (const auto& technique : techniques) {
            const auto asked = static_cast<AaTechnique&>(*technique).samplePoints(frame);
            if (&technique == &techniques.front())
                points = asked;
            else if (asked != centre)
                throw Error(ErrorCode::Usage, fmt::format("{} takes samples of its own", technique->entry().id()),
                            "put it first in the pipeline");
        }
    }
    // Only the last picture of a frame is seen: what informs is taken from it.
    const bool captures = recorder.capturing;
    FrameTargets produced;
    for (std::size_t i = 0; i < points.size(); ++i) {
        frame.sample = std::uint32_t(i);
        frame.isLastSample = i + 1 == points.size();
        frame.jitter_px = points[i];
        frame.view = jittered(frame.centredView, glm::dvec2(points[i]));
        recorder.capturing = captures && frame.isLastSample;
        produced = {};
        produced = renderSample(frame, settings, request);
    }
    frame.previousView = frame.centredView;
    return produced;
}

FrameTargets Renderer::Impl::renderSample(FrameContext& frame, const RenderSettings& settings,
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

    const Composed composed = composer.compose(frame, settings, lights, produced.ao, produced.indirect);
    produced.color = composed.color;
    frame.edgeColors = composed.edgeColors.get();
    if (isNeutral(settings.aa)) return produced;
    const auto& techniques = slots.get("aa", settings.aa, frame);
    for (const auto& technique : techniques) {
        // What follows the one that takes the samples sees its picture, once.
        if (&technique != &techniques.front() && !frame.isLastSample) break;
        auto output = targets.take(produced.color->desc(), "anti-aliased");
        static_cast<AaTechnique&>(*technique).render(frame, *produced.color, *output);
        produced.color = output;
    }
    frame.edgeColors = nullptr;
    return produced;
}

}  // namespace ombrage
