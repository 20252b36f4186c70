// SPDX-License-Identifier: MIT
// ao/blocks: occlusion from the depths around a pixel, weighted by angle and distance. See blocks.md.
#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/ao/blocks/own.h"

namespace ombrage {

namespace blocks {

ParamTable BlocksParams::describe() {
    using P = BlocksParams;
    return screenAoTable(
        {field(&P::samples, "samples")
             .range(4, 64)
             .tune(8, 64)
             .effect(ParamEffect::Define)
             .help("Size of the kernel: depths read per pixel; the published sizes are 16, 32 and 64. More cost time, "
                   "fewer give noise."),
         field(&P::offsets, "offsets")
             .effect(ParamEffect::Define)
             .help("Where samples are put: in a disk of the picture, or in the half ball over the surface and then "
                   "projected. The half ball wastes fewer samples on grazing surfaces and misses what lies beside it."),
         field(&P::kernel, "kernel")
             .effect(ParamEffect::Host)
             .help(
                 "How samples spread: evenly, denser towards the receiver, or as evenly with less noise by importance "
                 "sampling."),
         field(&P::intensity, "intensity")
             .range(0, 32)
             .tune(0.5, 8)
             .help("The factor s before the mean of the weights: higher is darker."),
         field(&P::angle_rad, "angle", Unit::Degree)
             .range(0, 90)
             .tune(45, 90)
             .help("Surfaces farther than this from the normal do not occlude: lower hides the facets and the noise of "
                   "flat surfaces, and with them shallow creases."),
         field(&P::bias_m, "bias", Unit::Metre)
             .range(0, 1)
             .tune(0, 0.05)
             .help("Lifts the receiver along its normal: hides self-occlusion of rough surfaces, loses contact.")});
}

class Blocks final : public ScreenAoTechniqueOf<BlocksParams> {
protected:
    ScreenAoPass pass(FrameContext&) override {
        return {.fragmentPath = "ao/blocks/blocks.frag", .bind = [this](const gl::Program& program) {
                    const std::vector<glm::vec4> kernel = makeKernel(p().offsets, p().kernel, p().samples);
                    program.set("u_kernel", kernel.data(), p().samples);
                }};
    }
};

}  // namespace blocks

using blocks::Blocks;

OMBRAGE_TECHNIQUE(
    ao, blocks, Blocks,
    {.title = "Kernel of angle- and distance-weighted depths",
     .summary = "Reads the surfaces found under a kernel of offsets turned from pixel to pixel, and darkens "
                "by those that rise over the tangent plane within the radius.",
     .papers = {"mittring2007", "blinn1978bump", "vogel1979", "jimenez2014noise"},
     .limits = "Sees only what the picture shows: no occluder behind the nearest surface or beyond the "
               "picture's border, and the formula is no visibility, so its scale is fitted.",
     .usesSeed = true,
     .integrand = integrandOf(&blocks::makeIntegrand)})

}  // namespace ombrage
