// SPDX-License-Identifier: MIT
#include "techniques/shared/volume_views.h"

#include "render/frame_context.h"
#include "techniques/shared/volume_fill.h"

namespace ombrage {

namespace {

constexpr const char* kStencil = "volume-stencil";
constexpr const char* kQuads = "volume-quads";
constexpr const char* kSilhouette = "volume-silhouette";
constexpr const char* kFill = "volume-fill";
constexpr const char* kCaps = "volume-caps";

/// Length of what is shown of a silhouette's sides, in diagonals of the casters' bounds.
constexpr float kFin = 0.004f;

void showQuads(FrameContext& frame, const LightFrame& light, const ShadowVolumes& volumes, const VolumeChoice& chosen,
               bool edgesOnly) {
    const auto pass = frame.pass(edgesOnly ? "show silhouettes" : "show volumes");
    const gl::Texture picture = volumeBackdrop(frame);
    const gl::Framebuffer target({{&picture}}, {&frame.gbuffer->depth}, "volume view");
    target.bind();
    gl::DrawState state = volumeOverlay();
    gl::apply(state);
    VolumeLook look{.fragmentPath = kVolumeTintPath};
    if (!edgesOnly) {
        volumes.draw(frame, light, VolumePart::Sides, VolumePart::Sides, chosen, look);
        // An outline counts once, however many lie there: many sides in few pixels would be outlines alone.
        state.blendEquation = GL_MAX;
        state.wireframe = true;
        gl::apply(state);
        look.defines = {{"OUTLINE", ""}};
        volumes.draw(frame, light, VolumePart::Sides, VolumePart::Sides, chosen, look);
    } else {
        // Sides cut short, seen through everything.
        state.blend = false;
        state.depthTest = false;
        gl::apply(state);
        look.defines = {{"EDGE", ""}};
        look.distance_m = kFin * glm::length(frame.gpuScene->casterUpper() - frame.gpuScene->casterLower());
        volumes.draw(frame, light, VolumePart::Sides, VolumePart::Sides, chosen, look);
    }
    frame.expose(edgesOnly ? kSilhouette : kQuads, picture, ShowAs::Color);
}

void showCaps(FrameContext& frame, const LightFrame& light, const ShadowVolumes& volumes, const VolumeChoice& chosen) {
    const auto pass = frame.pass("show caps");
    const gl::Texture picture = volumeBackdrop(frame);
    const gl::Framebuffer target({{&picture}}, {&frame.gbuffer->depth}, "volume view");
    target.bind();
    gl::DrawState state = volumeOverlay();
    gl::apply(state);
    VolumeLook look{.fragmentPath = kVolumeTintPath, .defines = {{"LIGHT_CAP", ""}}};
    for (const VolumePart part : {VolumePart::LightCaps, VolumePart::InwardLightCaps})
        volumes.draw(frame, light, part, part, chosen, look);
    // Those at infinity are behind everything.
    state.depthTest = false;
    gl::apply(state);
    look.defines = {{"DARK_CAP", ""}};
    volumes.draw(frame, light, VolumePart::DarkCaps, VolumePart::DarkCaps, chosen, look);
    frame.expose(kCaps, picture, ShowAs::Color);
}

}  // namespace

gl::Texture volumeBackdrop(FrameContext& frame) {
    gl::Texture picture({.format = GL_RGBA16F, .width = frame.width, .height = frame.height}, "volume view");
    const gl::Framebuffer target({{&picture}}, {}, "volume view");
    target.bind();
    gl::apply({});
    frame.bindGBuffer();
    frame.program({{GL_VERTEX_SHADER, "ombrage/fullscreen.vert"}, {GL_FRAGMENT_SHADER, "shared/volume_backdrop.frag"}});
    frame.drawFullscreen();
    return picture;
}

gl::DrawState volumeOverlay() {
    gl::DrawState state;
    state.depthTest = true;
    state.depthFunc = GL_GEQUAL;
    // The more lie there already, the less each adds: hundreds are no white spot.
    state.blend = true;
    state.blendDestination = GL_ONE_MINUS_SRC_COLOR;
    return state;
}

std::vector<PassInfo> volumePasses() {
    return {{kStencil, "count of volumes that hold the visible surface"},
            {kQuads, "the volumes' sides, translucent, with their outlines"},
            {kSilhouette, "the edges that are extruded"},
            {kCaps, "the caps that are made: at the caster yellow, at the far end blue, seen through everything"},
            {kFill, "triangles over each pixel that z-fail would draw"}};
}

void showVolumes(FrameContext& frame, const LightFrame& light, const ShadowVolumes& volumes) {
    showVolumes(frame, light, volumes, volumes.casters());
}

void showVolumes(FrameContext& frame, const LightFrame& light, const ShadowVolumes& volumes,
                 const VolumeChoice& chosen) {
    if (frame.wants(kStencil)) frame.expose(kStencil, frame.gbuffer->depth, ShowAs::Stencil);
    if (frame.wants(kQuads)) showQuads(frame, light, volumes, chosen, false);
    if (frame.wants(kSilhouette)) showQuads(frame, light, volumes, chosen, true);
    if (frame.wants(kCaps)) showCaps(frame, light, volumes, chosen);
    if (!frame.wants(kFill)) return;
    const FrameContext::Uncounted aside(frame);
    ShadowVolumeOptions endless = volumes.options();
    endless.slabs = false;
    frame.expose(kFill, drawFill(frame, light, endless), ShowAs::Count);
}

void showNothing(FrameContext& frame, std::initializer_list<const char*> names) {
    for (const char* name : names) {
        if (!frame.wants(name)) continue;
        const gl::Texture nothing({.format = GL_R32F, .width = frame.width, .height = frame.height}, "nothing to show");
        gl::Framebuffer({{&nothing}}, {}, "nothing to show").clearColor(0, glm::vec4(0));
        frame.expose(name, nothing, ShowAs::Count);
    }
}

}  // namespace ombrage
