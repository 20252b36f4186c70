// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "render/frame_context.h"
#include "techniques/shared/moment_map.h"

namespace ombrage {

/// A technique that looks up one MomentMap. Its parameters derive from MomentMapParams.
template <typename P>
class MomentTechniqueOf : public ShadowLookupTechniqueOf<P> {
public:
    void prepare(FrameContext&) override { m_map.reset(); }
    void sceneMoved(FrameContext&) override { m_map.sceneMoved(); }

    TexelFootprint footprint() const override { return m_map.footprint(); }
    ShadowRange range() const override { return m_range; }
    std::uint64_t gpuBytes() const override { return m_map.gpuBytes(); }

protected:
    /// Brings the map up to date and looks it up by the GLSL of `path`.
    ShadowLookup lookUp(FrameContext& frame, const LightFrame& light, const MomentMap::Statistics& statistics,
                        const std::string& path) {
        m_map.update(frame, *this, light, this->p(), statistics);
        return lookUp(frame, path);
    }

    /// The same of a map that is up to date.
    ShadowLookup lookUp(FrameContext& frame, const std::string& path) {
        m_range = m_map.shadowRange(frame);
        m_map.exposeTo(frame);
        return m_map.lookup(path);
    }

    MomentMap& map() { return m_map; }

private:
    MomentMap m_map;
    ShadowRange m_range;
};

}  // namespace ombrage
