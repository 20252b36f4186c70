// SPDX-License-Identifier: MIT
// filter/none: a copy, the baseline of cost.
#include "render/technique.h"
#include "techniques/shared/copy.h"

namespace ombrage {
namespace {

class NoFilter final : public FilterTechniqueOf<> {
public:
    void render(FrameContext&, const gl::Texture& input, const gl::Texture& output) override {
        copyTexture(input, output);
    }
};

}  // namespace

OMBRAGE_TECHNIQUE(filter, none, NoFilter,
                  {.title = "No filter",
                   .summary = "The image unchanged: the baseline of cost.",
                   .limits = "Cleans nothing.",
                   .neutral = true})

}  // namespace ombrage
