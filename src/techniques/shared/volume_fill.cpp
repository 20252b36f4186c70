// SPDX-License-Identifier: MIT
#include "techniques/shared/volume_fill.h"

#include <numeric>
#include <vector>

#include "render/frame_context.h"

namespace ombrage {

gl::Texture drawFill(FrameContext& frame, const LightFrame& light, const ShadowVolumeOptions& options) {
    ShadowVolumes volumes;
    volumes.update(frame, light, options);
    return drawFill(frame, light, volumes, volumes.casters());
}

gl::Texture drawFill(FrameContext& frame, const LightFrame& light, const ShadowVolumes& volumes,
                     const VolumeChoice& chosen) {
    gl::Texture count({.format = GL_R32F, .width = frame.width, .height = frame.height}, "volume fill");
    const gl::Framebuffer target({{&count}}, {}, "volume fill");
    target.bind();
    target.clearColor(0, glm::vec4(0));
    gl::DrawState state;
    state.blend = true;
    state.depthClamp = frame.view.orthographic;
    gl::apply(state);
    volumes.draw(frame, light, VolumePart::Sides, VolumePart::InwardLightCaps, chosen,
                 {.fragmentPath = "shared/volume_one.frag"});
    return count;
}

double sumOfFill(const gl::Texture& fill) {
    const std::size_t pixels = std::size_t(fill.width()) * std::size_t(fill.height());
    std::vector<float> fragments(pixels);
    fill.download(0, 0, GL_RED, GL_FLOAT, pixels * sizeof(float), fragments.data());
    return std::accumulate(fragments.begin(), fragments.end(), 0.0);
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
