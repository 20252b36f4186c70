// SPDX-License-Identifier: MIT
// ao/ssdo: directions from which light comes, each tested at one point along it. See ssdo.md.
#include <cmath>

#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/ao/ssdo/own.h"

namespace ombrage {

namespace ssdo {

ParamTable SsdoParams::describe() {
    using P = SsdoParams;
    return screenAoTable({field(&P::samples, "samples")
                              .range(4, 64)
                              .tune(8, 64)
                              .effect(ParamEffect::Define)
                              .help("Directions per pixel, each with one point. More cost time, fewer give noise.")});
}

namespace {

/// Cosine-weighted unit directions about z, and in w lengths even in [0,1], both stratified.
std::vector<glm::vec4> makeKernel(int count) {
    constexpr double kGoldenAngle = 2.39996322972865332, kPlastic = 0.7548776662466927;
    std::vector<glm::vec4> kernel;
    for (int i = 0; i < count; ++i) {
        const double u = (i + 0.5) / count, angle = i * kGoldenAngle, v = 0.5 + i * kPlastic;
        kernel.emplace_back(std::sqrt(u) * std::cos(angle), std::sqrt(u) * std::sin(angle), std::sqrt(1 - u),
                            v - std::floor(v));
    }
    return kernel;
}

}  // namespace

class Ssdo final : public ScreenAoTechniqueOf<SsdoParams> {
protected:
    ScreenAoPass pass(FrameContext&) override {
        return {.fragmentPath = "ao/ssdo/ssdo.frag", .bind = [this](const gl::Program& program) {
                    const std::vector<glm::vec4> kernel = makeKernel(p().samples);
                    program.set("u_kernel", kernel.data(), p().samples);
                }};
    }
};

}  // namespace ssdo

using ssdo::Ssdo;

OMBRAGE_TECHNIQUE(ao, ssdo, Ssdo,
                  {.title = "Directional occlusion, one point per direction",
                   .summary = "Takes cosine-weighted directions over each surface point, puts a point on each at a "
                              "length of its own, and blocks the direction if the picture's depths hide the point.",
                   .papers = {"ritschel2009ssdo"},
                   .limits = "One point stands for its whole direction: occluders in front of it are missed, and "
                             "whatever hides it from the eye counts, however far in front it is.",
                   .usesSeed = true,
                   .integrand = integrandOf(&ssdo::makeIntegrand)})

}  // namespace ombrage
