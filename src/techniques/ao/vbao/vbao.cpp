// SPDX-License-Identifier: MIT
// ao/vbao: the sectors of slices that thick occluders leave open. See vbao.md.
#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/ao/vbao/own.h"

namespace ombrage {

namespace vbao {

ParamTable VbaoParams::describe() {
    using P = VbaoParams;
    return aoSliceTable(
        {field(&P::thickness_m, "thickness", Unit::Metre)
             .range(0, 100)
             .tune(0.02, 2)
             .help("How far every occluder reaches behind its front, away from the eye: thinner lets light past, and "
                   "through what is thicker."),
         field(&P::sectors, "sectors")
             .effect(ParamEffect::Define)
             .help("How a slice's 32 sectors spread: even in the cosine-weighted hemisphere, as the truth T1 counts "
                   "it, or even in the angle, as published.")});
}

class Vbao final : public ScreenAoTechniqueOf<VbaoParams> {
protected:
    ScreenAoPass pass(FrameContext&) override {
        return {.fragmentPath = "ao/vbao/vbao.frag", .depthLevels = p().mips > 0 ? p().mips + 1 : 0};
    }
};

}  // namespace vbao

using vbao::Vbao;

OMBRAGE_TECHNIQUE(
    ao, vbao, Vbao,
    {.title = "Visibility bitmask: slices of 32 sectors",
     .summary =
         "Marks, in each of a few slices about the way to the eye, the sectors between the front and the back of "
         "everything near, so that light passes behind what is thin.",
     .papers = {"therrien2023", "jimenez2016gtao", "mcguire2012sao", "rhee2015"},
     .limits =
         "One thickness for everything: thin for walls, thick for leaves; blind for what the picture does not show.",
     .usesSeed = true,
     .integrand = integrandOf(&vbao::makeIntegrand)})

}  // namespace ombrage
