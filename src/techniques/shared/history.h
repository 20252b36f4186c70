// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/param_table.h"
#include "render/frame_context.h"

namespace ombrage {

/// Of filters that gather over frames, with shared/history.glsl: a member `depthTolerance` as a parameter.
template <typename P>
ParamField depthToleranceField(float P::*member) {
    return field(member, "depth-tolerance")
        .range(0, 1)
        .tune(0.002, 0.1)
        .help(
            "Difference of depth, as a share of it, beyond which a pixel of the frame before shows something "
            "else: higher mixes surfaces, lower forgets slanted ones.");
}

/// Puts the uniforms of shared/history.glsl.
void setReprojection(const gl::Program& program, const FrameContext& frame, bool hasHistory);

/// Offers one channel of a texture of the picture's size, times `scale` and at most 1, to `--show`; only when it is
/// wanted. Not part of what is timed and counted.
void exposeChannel(FrameContext& frame, const std::string& name, const gl::Texture& texture, int channel, float scale);

}  // namespace ombrage
