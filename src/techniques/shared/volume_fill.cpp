// SPDX-License-Identifier: MIT
#include "techniques/shared/volume_fill.h"

#include <vector>

#include "render/frame_context.h"

namespace ombrage {

gl::Texture drawFill(FrameContext& frame, const LightFrame& light, const ShadowVolumeOptions& options) {
    ShadowVolumes volumes;
    volumes.update(frame, light, options);
    gl::Texture count({.format = GL_R32F, .width = frame.width, .height = frame.height}, "volume fill");
    const gl::Framebuffer target({{&count}}, {}, "volume fill");
    target.bind();
    target.clearColor(0, glm::vec4(0));
    gl::DrawState state;
    state.blend = true;
    state.depthClamp = frame.view.orthographic;
    gl::apply(state);
    volumes.draw(frame, light, VolumePart::Sides, VolumePart::InwardLightCaps, volumes.casters(),
                 {.fragmentPath = "shared/volume_one.frag"});
    return count;
}

VolumeFill countFill(FrameContext& frame, const LightFrame& light, const ShadowVolumeOptions& options,
                     const gl::Texture* mask) {
    const FrameContext::Uncounted aside(frame);
    const gl::Texture count = drawFill(frame, light, options);
    const std::size_t pixels = std::size_t(frame.width) * std::size_t(frame.height);
    std::vector<float> fragments(pixels), weights(pixels, 1.0f);
    count.download(0, 0, GL_RED, GL_FLOAT, pixels * sizeof(float), fragments.data());
    if (mask != nullptr) mask->download(0, 0, GL_RED, GL_FLOAT, pixels * sizeof(float), weights.data());
    VolumeFill fill;
    for (std::size_t i = 0; i < pixels; ++i) {
        fill.all += double(fragments[i]);
        fill.counted += weights[i] != 0.0f ? double(fragments[i]) : 0.0;
    }
    return fill;
}

void reportFill(FrameContext& frame, const VolumeFill& fill) {
    frame.counter("fill of z-fail", fill.all);
    frame.counter("fill saved", fill.all - fill.counted);
}

}  // namespace ombrage
