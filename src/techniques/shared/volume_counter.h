// SPDX-License-Identifier: MIT
#pragma once

#include "gl/objects.h"
#include "techniques/shared/light_region.h"
#include "techniques/shared/shadow_volume.h"

namespace ombrage {

/// Counts, in the stencil plane of the G-buffer's depth, how many volumes hold each visible point, and writes the
/// shadow from that. One object per light and frame; the volumes are up to date.
class VolumeCounter {
public:
    VolumeCounter(FrameContext& frame, const LightFrame& light, const ShadowVolumes& volumes, bool twoSided);

    /// Clears the count of every pixel to that of the eye. Opens no pass, as none of these does: whoever calls names
    /// them.
    void begin(int atTheEye) const;

    /// Heidmann 1991: faces before the surface, +1 where a volume is entered and -1 where it is left. With `clampDepth`
    /// the near plane cuts nothing, and counting starts at the eye.
    void zPass(const VolumeChoice& chosen, bool clampDepth) const;

    /// Light caps by z-pass, of volumes that begin apart from their casters (VolumeSlab::near).
    void zPassLightCaps(const VolumeChoice& chosen, bool clampDepth) const;

    /// Everitt and Kilgard 2002, section 3.3: faces behind the surface, +1 where a volume is left and -1 where it is
    /// entered. Needs the caps.
    void zFail(const VolumeChoice& chosen) const;

    /// Hornus 2005: what holds each point of the near plane, from the caps between it and the light: where z-pass
    /// starts.
    void nearPlane(const VolumeChoice& chosen) const;

    /// Visibility 0 where the count is not 0.
    void darken(const gl::Texture& visibility) const;

    /// From now on every fragment of a volume adds 1 to an R32F image of the picture's size, and nothing else happens.
    void addFragmentsTo(const gl::Texture& image);

    /// The stencil's bit that a pixel needs to be counted, after restrictToMarked(); the count has the bits below.
    static constexpr int kMarked = 0x80;

    /// Only marked pixels are counted; call before begin().
    void restrictToMarked() { m_maskBit = kMarked; }

    /// Sets that bit where the mask, one channel of the picture's size, is not 0; after begin().
    void mark(const gl::Texture& mask) const;

private:
    gl::DrawState state() const;
    void draw(gl::DrawState state, VolumePart first, VolumePart last, const VolumeChoice& chosen,
              VolumeLook look = {}) const;

    FrameContext& m_frame;
    const LightFrame& m_light;
    const ShadowVolumes& m_volumes;
    bool m_twoSided;
    int m_maskBit = 0;
    bool m_addsFragments = false;
    LightRegion m_region;
    gl::Framebuffer m_target;
};

}  // namespace ombrage
