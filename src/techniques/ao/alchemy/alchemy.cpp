// SPDX-License-Identifier: MIT
// ao/alchemy: ambient obscurance from points of a disk, without an angle or a ray. See alchemy.md.
#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/ao/alchemy/own.h"

namespace ombrage {

namespace alchemy {

ParamTable AlchemyParams::describe() {
    using P = AlchemyParams;
    return screenAoTable(
        {field(&P::samples, "samples")
             .range(1, 64)
             .tune(6, 64)
             .effect(ParamEffect::Define)
             .help("Depths read per pixel (s): more cost time, fewer give noise."),
         field(&P::intensity, "intensity")
             .range(0, 8)
             .tune(0.2, 3)
             .help("sigma in radii, the distance up to which the falloff is 1: higher is darker."),
         field(&P::contrast, "contrast")
             .range(0.25, 8)
             .tune(0.5, 2)
             .help("The power k of the visibility: higher darkens what is occluded already."),
         field(&P::bias, "bias")
             .range(0, 0.05, Scale::Linear)
             .tune(0, 0.005)
             .help(
                 "beta, metres for each metre of depth that surfaces must rise: hides what depths round to and facets, "
                 "loses contact."),
         field(&P::epsilon, "epsilon")
             .range(0.0001, 1, Scale::Log)
             .help("In radii; its square keeps the quotient finite: higher lets near surfaces count for less.")});
}

class Alchemy final : public ScreenAoTechniqueOf<AlchemyParams> {
protected:
    ScreenAoPass pass(FrameContext&) override { return {.fragmentPath = "ao/alchemy/alchemy.frag"}; }
};

}  // namespace alchemy

using alchemy::Alchemy;

OMBRAGE_TECHNIQUE(
    ao, alchemy, Alchemy,
    {.title = "Alchemy obscurance",
     .summary = "Reads surfaces at points of a disk and darkens by how far each rises over the tangent plane over the "
                "square of its distance: a falloff chosen so that the formula has neither angles nor roots.",
     .papers = {"mcguire2011alchemy", "vogel1979", "jimenez2014noise"},
     .limits = "Sees only what the picture shows; surfaces far in front of the receiver darken it as well, because the "
               "falloff has no end; the points of the disk are not even in direction, so its scale is fitted.",
     .usesSeed = true,
     .integrand = integrandOf(&alchemy::makeIntegrand)})

}  // namespace ombrage
