// SPDX-License-Identifier: MIT
// filter/bilateral-separable: a horizontal, then a vertical edge-stopping blur. See bilateral-separable.md.
#include "techniques/shared/edge_stop_params.h"
#include "techniques/shared/filter_pass.h"

namespace ombrage {
namespace {

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
        filterPass(frame, *this, name, "filter/bilateral-separable/bilateral_separable.frag", from, to,
                   [&](const gl::Program& program) { program.set("u_step", step); });
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
