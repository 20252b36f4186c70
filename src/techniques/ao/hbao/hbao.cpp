// SPDX-License-Identifier: MIT
// ao/hbao: occlusion from the horizon that the depths show in several directions. See hbao.md.
#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/ao/hbao/own.h"

namespace ombrage {

namespace hbao {

ParamTable HbaoParams::describe() {
    using P = HbaoParams;
    return screenAoTable({field(&P::directions, "directions")
                              .range(1, 32)
                              .tune(4, 16)
                              .effect(ParamEffect::Define)
                              .help("Directions in which the horizon is looked for: more cost time, fewer give noise."),
                          field(&P::steps, "steps")
                              .range(1, 64)
                              .tune(3, 16)
                              .effect(ParamEffect::Define)
                              .help("Depths read in each direction: more cost time, fewer miss thin things."),
                          field(&P::angleBias_rad, "angle-bias", Unit::Degree)
                              .range(0, 60)
                              .tune(0, 45)
                              .help("What rises less over the tangent plane does not occlude: higher hides facets, and "
                                    "with them shallow creases."),
                          field(&P::jitter, "jitter")
                              .effect(ParamEffect::Define)
                              .help("Moves the steps from pixel to pixel: noise in the place of bands.")});
}

class Hbao final : public ScreenAoTechniqueOf<HbaoParams> {
protected:
    ScreenAoPass pass(FrameContext&) override { return {.fragmentPath = "ao/hbao/hbao.frag"}; }
};

}  // namespace hbao

using hbao::Hbao;

OMBRAGE_TECHNIQUE(
    ao, hbao, Hbao,
    {.title = "Horizon-based ambient occlusion",
     .summary = "Marches through the depths in several directions of the picture and takes away what lies between the "
                "tangent plane and the highest surface within the radius.",
     .papers = {"bavoil2008hbao", "jimenez2014noise"},
     .limits =
         "Sees only what the picture shows, and takes it for solid all the way back; weighs all directions alike, "
         "where light from the normal counts most; its cost grows with the steps that a large radius needs.",
     .usesSeed = true,
     .integrand = integrandOf(&hbao::makeIntegrand)})

}  // namespace ombrage
