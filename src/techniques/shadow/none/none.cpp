// SPDX-License-Identifier: MIT
// shadow/none: visibility 1, the baseline of cost.
#include "render/technique.h"

namespace ombrage {
namespace {

class NoShadow final : public ShadowTechniqueOf<> {
public:
    // The image comes cleared to 1.
    void render(FrameContext&, const LightFrame&, const gl::Texture&) override {}
};

}  // namespace

OMBRAGE_TECHNIQUE(shadow, none, NoShadow,
                  {.title = "No shadow",
                   .summary = "Visibility is 1 everywhere: the baseline of cost.",
                   .limits = "Casts no shadow.",
                   .domain = {.soft = true}, .neutral = true})

}  // namespace ombrage
