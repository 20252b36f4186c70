// SPDX-License-Identifier: MIT
// filter/bilateral-separable: a horizontal, then a vertical edge-stopping blur. See bilateral-separable.md.
#include <algorithm>

#include "render/frame_context.h"
#include "render/technique.h"

namespace ombrage {
namespace {

struct BilateralParams {
    int radius_px = 4;
    float sigma_px = 2.0f;
    float planeTolerance_px = 1.0f;
    float normalPower = 16.0f;

    static ParamTable describe() {
        using P = BilateralParams;
        return fields(
            field(&P::radius_px, "radius", Unit::Pixel)
                .range(0, 32)
                .tune(1, 12)
                .help("Neighbours taken on each side: more remove more noise and cost more; 0 changes nothing."),
            field(&P::sigma_px, "sigma", Unit::Pixel)
                .range(0.25, 32, Scale::Log)
                .tune(1, 8)
                .help("Standard deviation of the Gaussian over the picture: larger is smoother, and blurs "
                      "contacts."),
            field(&P::planeTolerance_px, "plane-tolerance", Unit::Pixel)
                .range(0.01, 1000, Scale::Log)
                .tune(0.1, 20)
                .help("Distance from the tangent plane at which a neighbour's weight has fallen by exp(-1/2), "
                      "in sizes of a pixel at the surface: larger lets light and shade bleed over steps, "
                      "smaller leaves noise on curved surfaces."),
            field(&P::normalPower, "normal-power")
                .range(0, 256)
                .tune(0, 64)
                .help("Exponent of the cosine between the shading normals: higher keeps creases and bumps "
                      "apart, 0 ignores normals."));
    }
};

class BilateralSeparable final : public FilterTechniqueOf<BilateralParams> {
public:
    void render(FrameContext& frame, const gl::Texture& input, const gl::Texture& output) override {
        const auto between = frame.targets->take(input.desc(), "bilateral-horizontal");
        blur(frame, "bilateral horizontal", input, *between, {1, 0});
        if (frame.wants("bilateral-horizontal")) frame.expose("bilateral-horizontal", *between, ShowAs::Value);
        blur(frame, "bilateral vertical", *between, output, {0, 1});
    }

private:
    void blur(FrameContext& frame, const char* name, const gl::Texture& from, const gl::Texture& to,
              const glm::ivec2& step) {
        const auto pass = frame.pass(name);
        const gl::Framebuffer target({{&to}}, {}, name);
        target.bind();
        gl::apply({});
        frame.bindGBuffer();
        from.bind(kFirstFreeUnit);
        const gl::Program& program =
            frame.fullscreenProgram(*this, "filter/bilateral-separable/bilateral_separable.frag");
        program.set("u_step", step);
        frame.drawFullscreen();
    }
};

}  // namespace

OMBRAGE_TECHNIQUE(
    filter, bilateral_separable, BilateralSeparable,
    {.title = "Separable bilateral filter",
     .summary = "Blurs along rows and then along columns, with weights that fall with the distance from "
                "the receiver's tangent plane and with the angle between normals.",
     .papers = {"tomasi1998bilateral", "pham2005separable"},
     .limits = "A bilateral filter is not separable: next to slanted edges the second pass mixes what the "
               "first has already mixed along another row; contacts and hard shadow edges are softened.",
     .passes = {{"bilateral-horizontal", "the image after the horizontal pass"}}})

}  // namespace ombrage
