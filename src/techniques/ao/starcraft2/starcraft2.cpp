// SPDX-License-Identifier: MIT
// ao/starcraft2: points of the half ball over the surface, hidden by how much. See starcraft2.md.
#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/ao/starcraft2/own.h"
#include "techniques/shared/ao_kernel.h"

namespace ombrage {

namespace starcraft2 {

ParamTable Starcraft2Params::describe() {
    using P = Starcraft2Params;
    return screenAoTable({field(&P::samples, "samples")
                              .range(4, 64)
                              .tune(8, 64)
                              .effect(ParamEffect::Define)
                              .help("Points per pixel; the game took 8 to 32. More cost time, fewer give noise."),
                          field(&P::full, "full")
                              .range(0, 100)
                              .tune(0.1, 2)
                              .help("A surface up to this many radii in front of a point hides it fully."),
                          field(&P::none, "none")
                              .range(0, 100)
                              .tune(0.5, 8)
                              .help("A surface more than this many radii in front of a point does not hide it: lower "
                                    "takes away halos behind edges, and with them occluders seen from above."),
                          field(&P::power, "power")
                              .range(0.125, 8)
                              .tune(0.25, 4)
                              .help("Exponent of the fall from full to none: higher falls sooner."),
                          field(&P::intensity, "intensity")
                              .range(0, 8)
                              .tune(0.5, 2)
                              .help("Factor of the hidden share: higher is darker.")});
}

class Starcraft2 final : public ScreenAoTechniqueOf<Starcraft2Params> {
protected:
    ScreenAoPass pass(FrameContext&) override {
        return {.fragmentPath = "ao/starcraft2/starcraft2.frag", .bind = [this](const gl::Program& program) {
                    const std::vector<glm::vec4> kernel = aoBallKernel(p().samples);
                    program.set("u_kernel", kernel.data(), p().samples);
                }};
    }
};

}  // namespace starcraft2

using starcraft2::Starcraft2;

OMBRAGE_TECHNIQUE(ao, starcraft2, Starcraft2,
                  {.title = "Half ball by flipping, falling off with the depth between",
                   .summary = "Counts how many points of the half ball over each surface point the picture's depths "
                              "hide, and less where what hides them is far in front.",
                   .papers = {"filion2008starcraft", "mittring2007"},
                   .limits = "A share of volume, not of light: all directions and all distances count alike. Sees only "
                             "what the picture shows.",
                   .usesSeed = true,
                   .integrand = integrandOf(&starcraft2::makeIntegrand)})

}  // namespace ombrage
