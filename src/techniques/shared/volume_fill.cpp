// SPDX-License-Identifier: MIT
#include "techniques/shared/volume_fill.h"

#include <numeric>
#include <vector>

#include "render/frame_context.h"
#include "techniques/shared/volume_counter.h"

namespace ombrage {

namespace {

std::vector<float> valuesOf(const gl::Texture& image) {
    std::vector<float> values(std::size_t(image.width()) * std::size_t(image.height()));
    image.download(0, 0, GL_RED, GL_FLOAT, values.size() * sizeof(float), values.data());
    return values;
}

}  // namespace

gl::Texture emptyFill(const FrameContext& frame) {
    gl::Texture image({.format = GL_R32F, .width = frame.width, .height = frame.height}, "volume fill");
    const gl::Framebuffer target({{&image}}, {}, "volume fill");
    target.clearColor(0, glm::vec4(0));
    return image;
}

double sumOf(const gl::Texture& fill) {
    const std::vector<float> values = valuesOf(fill);
    return std::accumulate(values.begin(), values.end(), 0.0);
}

gl::Texture drawFill(FrameContext& frame, const LightFrame& light, const ShadowVolumeOptions& options) {
    ShadowVolumes volumes;
    volumes.update(frame, light, options);
    return drawFill(frame, light, volumes, volumes.casters());
}

gl::Texture drawFill(FrameContext& frame, const LightFrame& light, const ShadowVolumes& volumes,
                     const VolumeChoice& chosen) {
    gl::Texture count = emptyFill(frame);
    VolumeCounter counter(frame, light, volumes, true);
    counter.addFragmentsTo(count);
    counter.zFail(chosen);
    return count;
}

VolumeFill countFill(FrameContext& frame, const LightFrame& light, const ShadowVolumeOptions& options,
                     const gl::Texture* mask) {
    const FrameContext::Uncounted aside(frame);
    const gl::Texture count = drawFill(frame, light, options);
    const std::vector<float> fragments = valuesOf(count);
    const std::vector<float> weights = mask != nullptr ? valuesOf(*mask) : std::vector<float>(fragments.size(), 1.0f);
    VolumeFill fill;
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        fill.all += double(fragments[i]);
        fill.counted += weights[i] != 0.0f ? double(fragments[i]) : 0.0;
    }
    return fill;
}

double fillOf(FrameContext& frame, const LightFrame& light, const ShadowVolumes& volumes, bool twoSided,
              const std::function<void(const VolumeCounter&)>& count) {
    const FrameContext::Uncounted aside(frame);
    const gl::Texture image = emptyFill(frame);
    VolumeCounter counter(frame, light, volumes, twoSided);
    counter.addFragmentsTo(image);
    count(counter);
    return sumOf(image);
}

void reportFill(FrameContext& frame, const VolumeFill& fill) {
    frame.counter("fill of z-fail", fill.all);
    frame.counter("fill saved", fill.all - fill.counted);
}

}  // namespace ombrage
