// SPDX-License-Identifier: MIT
// filter/bilateral: an edge-stopping blur over a square. See bilateral.md.
#include "techniques/shared/edge_stop_params.h"
#include "techniques/shared/filter_pass.h"

namespace ombrage {
namespace {

class Bilateral final : public FilterTechniqueOf<BilateralParams> {
public:
    void render(FrameContext& frame, const gl::Texture& input, const gl::Texture& output) override {
        filterPass(frame, *this, "bilateral", "filter/bilateral/bilateral.frag", input, output,
                   [](const gl::Program&) {});
    }
};

}  // namespace

OMBRAGE_TECHNIQUE(filter, bilateral, Bilateral,
                  {.title = "Bilateral filter",
                   .summary = "Blurs over a square of pixels, with weights that fall with the distance from the "
                              "receiver's tangent plane and with the angle between normals.",
                   .papers = {"tomasi1998bilateral"},
                   .limits = "Costs the square of its radius; contacts and hard shadow edges lie on one plane and are "
                             "softened."})

}  // namespace ombrage
