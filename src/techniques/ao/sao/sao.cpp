// SPDX-License-Identifier: MIT
// ao/sao: ambient obscurance whose cost does not depend on the radius, by coarser depths for samples far aside. See
// sao.md.
#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/ao/sao/own.h"

namespace ombrage {

namespace sao {

/// Levels of depths: the paper's finest and five coarser ones.
constexpr int kDepthLevels = 6;

ParamTable SaoParams::describe() {
    using P = SaoParams;
    return screenAoTable(
        {field(&P::samples, "samples")
             .range(1, 64)
             .tune(5, 64)
             .effect(ParamEffect::Define)
             .help("Depths read per pixel (s): more cost time, fewer give noise."),
         field(&P::turns, "turns")
             .range(1, 63)
             .tune(1, 31)
             .effect(ParamEffect::Define)
             .help("Turns of the spiral; with a divisor in common with samples they lie along few rays, which shows as "
                   "bands."),
         field(&P::intensity, "intensity").range(0, 16).tune(0.2, 4).help("sigma in radii: higher is darker."),
         field(&P::bias, "bias")
             .range(0, 0.5)
             .tune(0, 0.1)
             .help("beta in radii, the height that surfaces must rise: hides facets, loses contact."),
         field(&P::epsilon, "epsilon")
             .range(0.0001, 1, Scale::Log)
             .tune(0.005, 0.3)
             .help("In radii; its square keeps the quotient finite: higher lets near surfaces count for less."),
         field(&P::mips, "mips")
             .effect(ParamEffect::Define)
             .help("Samples far aside read coarser depths, which keeps them in cache: the cost does not grow with the "
                   "radius; thin things are missed at times."),
         field(&P::mipOffset, "mip-offset")
             .range(0, 8)
             .help("q: the finest depths serve samples up to 2^(q+1) pixels aside, each coarser level twice as far: "
                   "lower is faster and coarser.")});
}

class Sao final : public ScreenAoTechniqueOf<SaoParams> {
protected:
    ScreenAoPass pass(FrameContext&) override {
        return {.fragmentPath = "ao/sao/sao.frag", .depthLevels = p().mips ? kDepthLevels : 0};
    }
};

}  // namespace sao

using sao::Sao;

OMBRAGE_TECHNIQUE(
    ao, sao, Sao,
    {.title = "Scalable ambient obscurance",
     .summary =
         "Alchemy's obscurance with a falloff that ends at the radius, few samples on a spiral, and coarser depths "
         "for samples far aside, so that a large radius costs what a small one does.",
     .papers = {"mcguire2012sao", "mcguire2011alchemy", "jimenez2014noise"},
     .limits = "Sees only what the picture shows; coarser depths miss thin things far aside; the spiral is not even in "
               "direction, so its scale is fitted.",
     .usesSeed = true,
     .integrand = integrandOf(&sao::makeIntegrand)})

}  // namespace ombrage
