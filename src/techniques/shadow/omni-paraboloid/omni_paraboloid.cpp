// SPDX-License-Identifier: MIT
// shadow/omni-paraboloid: a point light's map on two paraboloids.
#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/shared/map_params.h"

namespace ombrage {
namespace {

struct OmniParaboloidParams : MapParams {
    bool extrapolate = true;

    static ParamTable describe() {
        return mapTable({field(&OmniParaboloidParams::extrapolate, "extrapolate")
                             .effect(ParamEffect::Define)
                             .help("Continues the surface that a texel shows to the point itself before it counts as "
                                   "its shadow: no acne in creases and under grazing light.")},
                        false);
    }
};

class OmniParaboloid final : public ShadowLookupTechniqueOf<OmniParaboloidParams> {
public:
    void prepare(FrameContext&) override { m_depth.reset(); }
    void sceneMoved(FrameContext&) override { m_depth.sceneMoved(); }

    ShadowLookup lookup(FrameContext& frame, const LightFrame& light) override {
        LightDepth::Options options = p().depthOptions();
        options.shape = LightShape::Paraboloids;
        options.margin_texels = 2;  // neighbours of the texels at a seam
        m_depth.update(frame, light, options);
        m_depth.setPlain();
        if (frame.wants("light-depth")) frame.expose("light-depth", m_depth.map(), ShowAs::LightDepth);
        m_footprint = m_depth.views().footprint(p().resolution);
        return {"shadow/omni-paraboloid/omni-paraboloid.glsl", m_depth.defines(),
                [this](const gl::Program& program) {
                    m_depth.views().setUniforms(program);
                    m_depth.map().bind(kFirstFreeUnit);
                },
                LightViews::perPass()};
    }

    TexelFootprint footprint() const override { return m_footprint; }
    std::uint64_t gpuBytes() const override { return m_depth.gpuBytes(); }

private:
    LightDepth m_depth;
    TexelFootprint m_footprint;
};

}  // namespace

OMBRAGE_TECHNIQUE(
    shadow, omni_paraboloid, OmniParaboloid,
    {.title = "Dual-paraboloid shadow map",
     .summary = "A point light's shadow map in two pictures, each of a half of all directions on a paraboloid.",
     .papers = {"brabec2002paraboloid", "dou2014adaptive"},
     .limits = "Straight edges become arcs there, so large triangles are cut into many small ones; texels in the "
               "middle are twice those at the rim.",
     .domain = {.sun = false, .spot = false, .soft = false},
     .passes = {{"light-depth", "depth seen from the light, upwards (the first of two paraboloids)"}}})

}  // namespace ombrage
