// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "gl/objects.h"
#include "render/frame_context.h"

namespace ombrage {

/// The picture's depths along the view axis, in metres, with coarser levels for samples far aside (McGuire, Mara,
/// Luebke 2012, section 2.3): each texel is one of the four below it, by a rotated grid, so that it stays a depth that
/// the picture has, of a pixel that is known (viewDepthPixel() in shared/view_depths.glsl). 0 where the picture shows
/// the sky.
class ViewDepths {
public:
    /// Makes `levels` (at least 1, at most what the picture's size allows) of the frame's G-buffer, in a pass of its
    /// own.
    void update(FrameContext& frame, int levels);

    /// R32F, of the picture's size.
    const gl::Texture& texture() const { return m_depths; }
    std::uint64_t gpuBytes() const { return m_depths ? gl::byteSize(m_depths.desc()) : 0; }

private:
    gl::Texture m_depths;
};

}  // namespace ombrage
