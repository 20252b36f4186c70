// SPDX-License-Identifier: MIT
// indirect/none: no bounced light, the baseline of cost.
#include "render/frame_context.h"
#include "render/technique.h"

namespace ombrage {
namespace {

class NoIndirect final : public IndirectTechniqueOf<> {
public:
    void render(FrameContext&, const gl::Texture& radiance) override {
        const gl::Framebuffer target({{&radiance}}, {}, "indirect/none");
        target.bind();
        gl::apply({});
        target.clearColor(0, glm::vec4(0.0f));
    }
};

}  // namespace

OMBRAGE_TECHNIQUE(indirect, none, NoIndirect,
                  {.title = "No indirect light",
                   .summary = "No light bounces: the baseline of cost.",
                   .limits = "Leaves shadows as dark as the ambient term makes them.", .neutral = true})

}  // namespace ombrage
