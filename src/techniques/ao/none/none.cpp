// SPDX-License-Identifier: MIT
// ao/none: visibility 1, the baseline of cost.
#include "render/frame_context.h"
#include "render/technique.h"

namespace ombrage {
namespace {

class NoOcclusion final : public AoTechniqueOf<> {
public:
    void render(FrameContext&, const gl::Texture& visibility) override {
        const gl::Framebuffer target({{&visibility}}, {}, "ao/none");
        target.bind();
        gl::apply({});
        target.clearColor(0, glm::vec4(1.0f));
    }
};

}  // namespace

OMBRAGE_TECHNIQUE(ao, none, NoOcclusion,
                  {.title = "No occlusion",
                   .summary = "Visibility of the surroundings is 1 everywhere: the baseline of cost.",
                   .limits = "Darkens nothing.",
                   .neutral = true})

}  // namespace ombrage
