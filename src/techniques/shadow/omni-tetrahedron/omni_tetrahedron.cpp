// SPDX-License-Identifier: MIT
// shadow/omni-tetrahedron: a point light's map on the four faces of a tetrahedron.
#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/shared/map_params.h"

namespace ombrage {
namespace {

struct OmniTetrahedronParams : MapParams {
    bool extrapolate = true;

    static ParamTable describe() {
        return mapTable({field(&OmniTetrahedronParams::extrapolate, "extrapolate")
                             .effect(ParamEffect::Define)
                             .help("Continues the surface that a texel shows to the point itself before it counts as "
                                   "its shadow: no acne in creases and under grazing light.")},
                        false);
    }
};

class OmniTetrahedron final : public ShadowLookupTechniqueOf<OmniTetrahedronParams> {
public:
    void prepare(FrameContext&) override { m_depth.reset(); }
    void sceneMoved(FrameContext&) override { m_depth.sceneMoved(); }

    ShadowLookup lookup(FrameContext& frame, const LightFrame& light) override {
        LightDepth::Options options = p().depthOptions();
        options.shape = LightShape::Tetrahedron;
        options.margin_texels = 2;  // neighbours of the texels at a seam
        m_depth.update(frame, light, options);
        m_depth.setPlain();
        if (frame.wants("light-depth")) frame.expose("light-depth", m_depth.map(), ShowAs::LightDepth);
        m_footprint = m_depth.views().footprint(p().resolution);
        return {"shadow/omni-tetrahedron/omni-tetrahedron.glsl", m_depth.defines(),
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
    shadow, omni_tetrahedron, OmniTetrahedron,
    {.title = "Tetrahedron shadow map",
     .summary =
         "A point light's shadow map in four perspective views, the faces of a tetrahedron, that fill two squares.",
     .papers = {"liao2010tetrahedron", "dou2014adaptive"},
     .limits = "The views are wide: texels in the middle of a face are several times those at its corners.",
     .domain = {.sun = false, .spot = false, .soft = false},
     .passes = {{"light-depth", "depth seen from the light in the first two of four faces"}}})

}  // namespace ombrage
