// SPDX-License-Identifier: MIT
#pragma once

#include "render/frame_context.h"
#include "techniques/shared/shadow_volume.h"

namespace ombrage {

/// The picture in tiles of 8x8 pixels: wholly lit, wholly dark, or crossed by the boundary of a volume. Perspective
/// cameras alone. One object per light and frame; the volumes are up to date.
class TileClasses {
public:
    TileClasses(FrameContext& frame, const LightFrame& light, const ShadowVolumes& volumes);

    /// Finds the depths of every tile's surfaces, and which tiles the chosen casters' volumes cross. Opens passes, as
    /// the next does.
    void findBoundary(const VolumeChoice& chosen);

    /// Counts, once for every tile, how many volumes hold its surfaces, by z-pass from the eye's own count.
    void classify(const VolumeChoice& chosen, int atTheEye);

    /// Writes a stencil value at all pixels of surfaces in the tiles of the boundary, or in dark ones. Draws into the
    /// bound target, which has the depth of the G-buffer.
    void stencil(bool boundary, int value, unsigned writeMask) const;

    /// 1 at the pixels of the boundary's tiles.
    gl::Texture boundaryMask() const;
    /// The classes in colours.
    gl::Texture picture() const;
    /// Puts how many there are of each into the record, which waits for the GPU.
    void report() const;

    std::size_t count() const { return std::size_t(m_classes->width()) * std::size_t(m_classes->height()); }

private:
    gl::Texture shown(GLenum format, bool boundaryAlone) const;

    FrameContext& m_frame;
    const LightFrame& m_light;
    const ShadowVolumes& m_volumes;
    TargetPool::Target m_cells;    ///< RG32F, one pixel per tile: farthest and nearest depth
    TargetPool::Target m_depth;    ///< between them, and the count
    TargetPool::Target m_classes;  ///< RG8: boundary, dark
};

}  // namespace ombrage
