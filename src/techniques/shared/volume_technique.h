// SPDX-License-Identifier: MIT
#pragma once

#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/shared/shadow_volume.h"
#include "techniques/shared/volume_counter.h"
#include "techniques/shared/volume_fill.h"
#include "techniques/shared/volume_views.h"

namespace ombrage {

/// A shadow technique that counts volumes in the stencil; each says how. P derives from VolumeParams.
template <typename P>
class VolumeTechniqueOf : public ShadowTechniqueOf<P> {
public:
    void prepare(FrameContext&) override { m_volumes.reset(); }

    void render(FrameContext& frame, const LightFrame& light, const gl::Texture& visibility) override {
        m_withCaps = needsCaps(frame, light);
        m_volumes.update(frame, light, ShadowVolumeOptions(this->p()), m_withCaps);
        m_volumes.report(frame);
        const VolumeCounter counter(frame, light, m_volumes, this->p().twoSided);
        count(frame, light, counter);
        showVolumes(frame, light, m_volumes);
        {
            const auto pass = frame.pass("shadow from stencil");
            counter.darken(visibility);
        }
        if (frame.countsSavings())
            frame.counter("fill", fillOf(frame, light, m_volumes, this->p().twoSided,
                                         [&](const VolumeCounter& own) { count(frame, light, own); }));
    }

    std::uint64_t gpuBytes() const override { return m_volumes.gpuBytes(); }

protected:
    /// The instances whose caps count() draws; empty: all.
    virtual VolumeChoice needsCaps(const FrameContext&, const LightFrame&) const { return {}; }

    /// Leaves in every pixel's stencil how many volumes hold its point.
    virtual void count(FrameContext& frame, const LightFrame& light, const VolumeCounter& counter) = 0;

    const ShadowVolumes& volumes() const { return m_volumes; }
    /// What needsCaps() said of this frame.
    const VolumeChoice& withCaps() const { return m_withCaps; }

private:
    ShadowVolumes m_volumes;
    VolumeChoice m_withCaps;
};

}  // namespace ombrage
