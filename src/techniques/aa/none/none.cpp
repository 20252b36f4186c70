// SPDX-License-Identifier: MIT
// aa/none: a copy, the baseline of cost.
#include "render/technique.h"
#include "techniques/shared/copy.h"

namespace ombrage {
namespace {

class NoAntiAliasing final : public AaTechniqueOf<> {
public:
    void render(FrameContext&, const gl::Texture& input, const gl::Texture& output) override {
        copyTexture(input, output);
    }
};

}  // namespace

OMBRAGE_TECHNIQUE(aa, none, NoAntiAliasing,
                  {.title = "No anti-aliasing",
                   .summary = "The picture unchanged: the baseline of cost.",
                   .limits = "Leaves every staircase edge.",
                   .neutral = true})

}  // namespace ombrage
