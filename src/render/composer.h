// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <ombrage/renderer.h>

#include "render/frame_context.h"
#include "render/technique.h"

namespace ombrage {

/// Visibility of one light, ready for lighting.
struct LitLight {
    LightFrame light;
    TargetPool::Target visibility;   ///< none: 1 everywhere, unless there is a lookup
    ShadowLookupTechnique* technique = nullptr;  ///< whose lookup it is
    std::optional<ShadowLookup> lookup = {};
    TargetPool::Target colored = {};  ///< visibility in red, green and blue, to be taken in its place; may be none
};

/// What lighting leaves.
struct Composed {
    TargetPool::Target color;       ///< RGBA16F, linear
    TargetPool::Target edgeColors;  ///< FrameContext::edgeColors; none without a multisampled G-buffer
};

/// Lights the G-buffer, once, after every technique: the one place where visibility, occlusion, indirect light and
/// materials meet.
class Composer {
public:
    /// Without `ao` nothing is occluded, without `indirect` nothing bounces.
    Composed compose(FrameContext& frame, const RenderSettings& settings, const std::vector<LitLight>& lights,
                     const TargetPool::Target& ao, const TargetPool::Target& indirect);

    /// Uploads and binds the block of ombrage/light.glsl; techniques' shaders read the same.
    void bindLight(const LightFrame& light, std::size_t instanceCount);

private:
    /// One pass a light into what is bound. @param ofSamples of the pixels that show several surfaces, each by itself
    void light(FrameContext& frame, const RenderSettings& settings, const std::vector<LitLight>& lights,
               const TargetPool::Target& ao, const TargetPool::Target& indirect, bool ofSamples);
    Composed applyNaively(FrameContext& frame, const RenderSettings& settings, const std::vector<LitLight>& lights,
                          const Composed& unshadowed);
    gl::Buffer m_lightBlock;
};

}  // namespace ombrage
