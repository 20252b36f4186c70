// SPDX-License-Identifier: MIT
// filter/gaussian: a blur that knows the image alone. See gaussian.md.
#include "techniques/shared/filter_pass.h"

namespace ombrage {
namespace {

struct GaussianParams {
    int radius_px = 4;
    float sigma_px = 2.0f;

    static ParamTable describe() {
        using P = GaussianParams;
        return ParamTable(
            {field(&P::radius_px, "radius", Unit::Pixel)
                 .range(0, 64)
                 .tune(1, 12)
                 .help("Neighbours taken on each side: more remove more noise and cost more; 0 changes nothing."),
             field(&P::sigma_px, "sigma", Unit::Pixel)
                 .range(0.25, 32, Scale::Log)
                 .tune(1, 8)
                 .help("Standard deviation: larger is smoother. A radius of 2 to 3 of them holds nearly all of it.")});
    }
};

class Gaussian final : public FilterTechniqueOf<GaussianParams> {
public:
    void render(FrameContext& frame, const gl::Texture& input, const gl::Texture& output) override {
        const auto between = frame.targets->take(input.desc(), "gaussian-horizontal");
        blur(frame, "gaussian horizontal", input, *between, {1, 0});
        if (frame.wants("gaussian-horizontal")) frame.expose("gaussian-horizontal", *between, ShowAs::Value);
        blur(frame, "gaussian vertical", *between, output, {0, 1});
    }

private:
    void blur(FrameContext& frame, const char* name, const gl::Texture& from, const gl::Texture& to,
              const glm::ivec2& step) {
        filterPass(frame, *this, name, "filter/gaussian/gaussian.frag", from, to,
                   [&](const gl::Program& program) { program.set("u_step", step); });
    }
};

}  // namespace

OMBRAGE_TECHNIQUE(filter, gaussian, Gaussian,
                  {.title = "Gaussian blur",
                   .summary = "Blurs along rows and then along columns, whatever the picture shows: what filters that "
                              "stop at edges are held against.",
                   .limits = "Light and shade bleed over every outline and crease.",
                   .passes = {{"gaussian-horizontal", "the image after the horizontal pass"}}})

}  // namespace ombrage
