// SPDX-License-Identifier: MIT
// shadow/omni-tetrahedron: a point light's map on the four faces of a tetrahedron.
#include "techniques/shared/nearest_map.h"

namespace ombrage {
namespace {

struct OmniTetrahedronParams : NearestMapParams {
    static ParamTable describe() { return table(false); }
};

class OmniTetrahedron final : public NearestMapTechniqueOf<OmniTetrahedronParams> {
public:
    ShadowLookup lookup(FrameContext& frame, const LightFrame& light) override {
        LightDepth::Options options = p().depthOptions();
        options.shape = LightShape::Tetrahedron;
        options.margin_texels = 2;  // neighbours of the texels at a seam
        return lookUp(frame, light, options, "shadow/omni-tetrahedron/omni-tetrahedron.glsl");
    }
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
