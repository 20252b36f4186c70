// SPDX-License-Identifier: MIT
// shadow/map: depth seen from the light (Williams 1978), with the whole family of biases. Everything but its GLSL and
// manual page.
#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/shared/map_params.h"

namespace ombrage {
namespace {

struct ShadowMapParams : MapParams {
    bool extrapolate = true;

    static ParamTable describe() {
        return mapTable({field(&ShadowMapParams::extrapolate, "extrapolate")
                             .effect(ParamEffect::Define)
                             .help("Continues the surface that a texel shows to the point itself before it counts as "
                                   "its shadow: no acne in creases and under grazing light.")});
    }
};

class ShadowMap final : public ShadowLookupTechniqueOf<ShadowMapParams> {
public:
    void prepare(FrameContext&) override { m_depth.reset(); }
    void sceneMoved(FrameContext&) override { m_depth.sceneMoved(); }

    ShadowLookup lookup(FrameContext& frame, const LightFrame& light) override {
        m_depth.update(frame, light, p().depthOptions());
        m_depth.setPlain();
        if (frame.wants("light-depth")) frame.expose("light-depth", m_depth.map(), ShowAs::LightDepth);
        m_footprint = m_depth.views().footprint(p().resolution);
        m_range = m_depth.views().range(frame.gpuScene->origin());
        return {"shadow/map/map.glsl", m_depth.defines(),
                [this](const gl::Program& program) {
                    m_depth.views().setUniforms(program);
                    m_depth.map().bind(kFirstFreeUnit);
                },
                LightViews::perPass()};
    }

    TexelFootprint footprint() const override { return m_footprint; }
    ShadowRange range() const override { return m_range; }
    std::uint64_t gpuBytes() const override { return m_depth.gpuBytes(); }

private:
    LightDepth m_depth;
    TexelFootprint m_footprint;
    ShadowRange m_range;
};

}  // namespace

OMBRAGE_TECHNIQUE(
    shadow, map, ShadowMap,
    {.title = "Shadow map",
     .summary = "Compares each surface's distance from the light with the depth that the light sees there.",
     .papers = {"williams1978", "wang1994seconddepth", "isidoro2006pcf", "holbert2011normaloffset", "dou2014adaptive",
                "ffxvi2023"},
     .limits = "Edges are as coarse as the map's texels; casters thinner than a texel break up.",
     .domain = {.rect = true, .soft = false},
     .passes = {{"light-depth", "depth seen from the light (the first of six views for a point light)"}}})

}  // namespace ombrage
