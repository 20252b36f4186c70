// SPDX-License-Identifier: MIT
#pragma once

#include "techniques/shared/light_depth.h"

namespace ombrage {

/// The nearest and the farthest depth of a light's map in ever larger squares: levels, of which the first covers two by
/// two texels (Guennebaud, Barthe and Paulin 2006, section 4.2). shared/depth_pyramid.glsl reads it. They stand side by
/// side in one level of a texture: some drivers (llvmpipe) take one level of detail for each two by two pixels, whoever
/// of them asks.
class DepthPyramid {
public:
    /// Makes it anew, in a pass of its own, where the map was drawn since.
    void update(FrameContext& frame, const LightDepth& depth);
    void reset() { m_drawn = 0; }

    /// RG32F, of the map's kind: what it holds nearest to the light and farthest from it.
    const gl::Texture& texture() const { return m_levels; }
    std::uint64_t gpuBytes() const { return m_levels ? gl::byteSize(m_levels.desc()) : 0; }

private:
    gl::Texture m_levels;
    std::uint64_t m_drawn = 0;  ///< of the map that it was made of
};

}  // namespace ombrage
