// SPDX-License-Identifier: MIT
// ao/gtao: the integral of visibility between two horizons, slice by slice. See gtao.md.
#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/ao/gtao/own.h"

namespace ombrage {

namespace gtao {

constexpr const char* kBentNormals = "bent-normals";

ParamTable GtaoParams::describe() {
    using P = GtaoParams;
    return aoSliceTable(
        {field(&P::falloff, "falloff")
             .range(0, 1)
             .tune(0, 1)
             .help("The outer share of the radius over which occluders fade out: 0 counts all of them in full, as the "
                   "truth T1 does; higher hides where the radius ends."),
         field(&P::thickness, "thickness")
             .range(0, 0.99)
             .tune(0, 0.9)
             .help("Share of a horizon that is lost over a side on which nothing confirms it: higher lets light past "
                   "thin occluders, and through the foot of thick ones; 0 takes all for endless."),
         field(&P::multiBounce, "multi-bounce")
             .effect(ParamEffect::Define)
             .help("Adds the light between surfaces of the pixel's albedo by a fit: less dark in bright creases. It is "
                   "no visibility then.")});
}

class Gtao final : public ScreenAoTechniqueOf<GtaoParams> {
public:
    void render(FrameContext& frame, const gl::Texture& visibility) override {
        ScreenAoTechniqueOf::render(frame, visibility);
        if (!frame.wants(kBentNormals)) return;
        const FrameContext::Uncounted informs(frame);
        const glm::ivec2 size = receiversOf(frame, p());
        const auto normals =
            frame.targets->take({.format = GL_RGBA16F, .width = size.x, .height = size.y}, kBentNormals);
        ScreenAoPass bent = pass(frame);
        bent.defines = {{"BENT", "1"}};
        screenAo().draw(frame, *this, p(), bent, *normals);
        frame.expose(kBentNormals, *normals, ShowAs::Color);
    }

protected:
    ScreenAoPass pass(FrameContext&) override {
        return {.fragmentPath = "ao/gtao/gtao.frag", .depthLevels = p().mips > 0 ? p().mips + 1 : 0};
    }
};

}  // namespace gtao

using gtao::Gtao;
using gtao::kBentNormals;

OMBRAGE_TECHNIQUE(
    ao, gtao, Gtao,
    {.title = "Ground-truth ambient occlusion: horizons in slices",
     .summary = "Finds the two horizons of each of a few slices about the way to the eye, and integrates the "
                "cosine-weighted visibility between them in closed form.",
     .papers = {"jimenez2016gtao", "mcguire2012sao", "rhee2015"},
     .limits = "Takes the nearest surface of the picture for endlessly thick: too dark behind what is thin, blind for "
               "what the picture does not show.",
     .passes = {{kBentNormals, "mean unoccluded direction in view space, halved and moved to [0,1]"}},
     .usesSeed = true,
     .integrand = integrandOf(&gtao::makeIntegrand)})

}  // namespace ombrage
