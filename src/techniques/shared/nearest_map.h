// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/shared/map_params.h"

namespace ombrage {

/// Parameters of shared/map_nearest.glsl. Parameter structs derive from it, with it as their only base.
struct NearestMapParams : MapParams {
    bool extrapolate = true;

    /// @param fitted  whether there is a fit to choose: not for point lights
    static ParamTable table(bool fitted = true) {
        return mapTable({field(&NearestMapParams::extrapolate, "extrapolate")
                             .effect(ParamEffect::Define)
                             .help("Continues the surface that a texel shows to the point itself before it counts as "
                                   "its shadow: no acne in creases and under grazing light.")},
                        fitted);
    }
};

/// A technique of one comparison with the nearest texel of a light's map.
template <typename P>
class NearestMapTechniqueOf : public ShadowLookupTechniqueOf<P> {
public:
    void prepare(FrameContext&) override { m_depth.reset(); }
    void sceneMoved(FrameContext&) override { m_depth.sceneMoved(); }

    TexelFootprint footprint() const override { return m_footprint; }
    std::uint64_t gpuBytes() const override { return m_depth.gpuBytes(); }

protected:
    /// Brings the map up to date and looks it up by the GLSL of `path`.
    ShadowLookup lookUp(FrameContext& frame, const LightFrame& light, const LightDepth::Options& options,
                        const std::string& path) {
        m_depth.update(frame, light, options);
        m_depth.setPlain();
        if (frame.wants("light-depth")) frame.expose("light-depth", m_depth.map(), ShowAs::LightDepth);
        m_footprint = m_depth.views().footprint(options.resolution);
        return {path, m_depth.defines(),
                [this](const gl::Program& program) {
                    m_depth.views().setUniforms(program);
                    m_depth.map().bind(kFirstFreeUnit);
                },
                LightViews::perPass()};
    }

    const LightDepth& depth() const { return m_depth; }

private:
    LightDepth m_depth;
    TexelFootprint m_footprint;
};

}  // namespace ombrage
