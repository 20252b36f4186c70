// SPDX-License-Identifier: MIT
// shadow/self: every model shades itself alone, by rays.
#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/shared/shadow_rays.h"

namespace ombrage {

namespace {

struct SelfParams {
    int samples = 16;

    static ParamTable describe() {
        using P = SelfParams;
        return fields(field(&P::samples, "samples")
                          .range(1, 256, Scale::Log)
                          .tune(1, 64)
                          .help("Rays per pixel to a light of some size: less noise in penumbrae for proportional "
                                "cost. Hard lights take one ray."));
    }
};

class Self final : public ShadowTechniqueOf<SelfParams> {
public:
    void prepare(FrameContext&) override { m_rays.reset(); }

    void render(FrameContext& frame, const LightFrame& light, const gl::Texture& visibility) override {
        constexpr const char* kSobol = "1";
        m_rays.draw(frame, *this, light, visibility,
                    {.samples = p().samples, .sameModel = true, .defines = {{"PATTERN", kSobol}}});
    }

    std::uint64_t gpuBytes() const override { return m_rays.gpuBytes(); }

private:
    ShadowRays m_rays;
};

}  // namespace

OMBRAGE_TECHNIQUE(shadow, self, Self,
                  {.title = "Self-shadowing alone",
                   .summary = "Every model of the scene is shaded by itself and by no other, which shows what the "
                              "shadows that models cast on each other add.",
                   .papers = {"appel1968", "whitted1980"},
                   .limits = "Leaves out every shadow that one model casts on another: measure it with --truth self.",
                   .domain = {.soft = true},
                   .usesSeed = true})

}  // namespace ombrage
