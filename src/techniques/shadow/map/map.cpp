// SPDX-License-Identifier: MIT
// shadow/map: depth seen from the light (Williams 1978), with the whole family of biases. Everything but its GLSL and
// manual page.
#include "techniques/shared/nearest_map.h"

namespace ombrage {
namespace {

struct ShadowMapParams : NearestMapParams {
    static ParamTable describe() { return table(); }
};

class ShadowMap final : public NearestMapTechniqueOf<ShadowMapParams> {
public:
    ShadowLookup lookup(FrameContext& frame, const LightFrame& light) override {
        ShadowLookup lookup = lookUp(frame, light, p().depthOptions(), "shadow/map/map.glsl");
        m_range = depth().views().range(frame.gpuScene->origin());
        return lookup;
    }

    ShadowRange range() const override { return m_range; }

private:
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
