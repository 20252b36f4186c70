// SPDX-License-Identifier: MIT
// shadow/omni-paraboloid: a point light's map on two paraboloids.
#include "techniques/shared/nearest_map.h"

namespace ombrage {
namespace {

struct OmniParaboloidParams : NearestMapParams {
    static ParamTable describe() { return table(false); }
};

class OmniParaboloid final : public NearestMapTechniqueOf<OmniParaboloidParams> {
public:
    ShadowLookup lookup(FrameContext& frame, const LightFrame& light) override {
        LightDepth::Options options = p().depthOptions();
        options.shape = LightShape::Paraboloids;
        options.margin_texels = 2;  // neighbours of the texels at a seam
        return lookUp(frame, light, options, "shadow/omni-paraboloid/omni-paraboloid.glsl");
    }
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
