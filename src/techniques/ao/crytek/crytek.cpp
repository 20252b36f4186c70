// SPDX-License-Identifier: MIT
// ao/crytek: how much of a ball around the surface lies in front of the depths. See crytek.md.
#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/ao/crytek/own.h"
#include "techniques/shared/ao_kernel.h"

namespace ombrage {

namespace crytek {

ParamTable CrytekParams::describe() {
    using P = CrytekParams;
    return screenAoTable({field(&P::pairs, "pairs")
                              .range(2, 32)
                              .tune(4, 32)
                              .effect(ParamEffect::Define)
                              .help("Half the number of points: each is taken with its opposite, of which a flat "
                                    "surface hides exactly one. More cost time, fewer give noise."),
                          field(&P::range, "range")
                              .range(0, 1000)
                              .tune(0.25, 8)
                              .help("A surface that lies nearer to the eye than the receiver by more than this many "
                                    "radii counts less, and by more than twice that not at all: lower takes away halos "
                                    "behind edges, and with them occluders seen at a grazing angle."),
                          field(&P::remap, "remap")
                              .effect(ParamEffect::Define)
                              .help("Twice the open share, so that a flat surface is white; without it flat is grey "
                                    "and convex edges are bright, as in the first pictures of the method.")});
}

class Crytek final : public ScreenAoTechniqueOf<CrytekParams> {
protected:
    ScreenAoPass pass(FrameContext&) override {
        return {.fragmentPath = "ao/crytek/crytek.frag", .bind = [this](const gl::Program& program) {
                    const std::vector<glm::vec4> kernel = aoBallKernel(p().pairs);
                    program.set("u_kernel", kernel.data(), p().pairs);
                }};
    }
};

}  // namespace crytek

using crytek::Crytek;

OMBRAGE_TECHNIQUE(
    ao, crytek, Crytek,
    {.title = "Share of a ball in front of the depths",
     .summary = "Counts how many points of a ball around each surface point the picture's depths hide; of "
                "a flat surface it is half.",
     .papers = {"mittring2007", "kajalin2009ssao"},
     .limits = "Knows no normal: half of its points lie in the surface itself, convex edges hide what "
               "concave ones add, and whatever stands in front of the picture darkens what is behind it.",
     .usesSeed = true,
     .integrand = integrandOf(&crytek::makeIntegrand)})

}  // namespace ombrage
