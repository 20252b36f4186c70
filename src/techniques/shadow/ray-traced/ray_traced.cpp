// SPDX-License-Identifier: MIT
// shadow/ray-traced: rays from the visible points to the light through a hierarchy in storage buffers.
#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/shared/shadow_rays.h"

namespace ombrage {

namespace {

/// Where the rays of one pixel go on the light.
enum class RayPattern { Random, Sobol, Rotated };

}  // namespace

template <>
struct EnumChoices<RayPattern> {
    static std::vector<std::string> names() { return {"random", "sobol", "rotated"}; }
};

namespace {

struct RayTracedParams {
    int samples = 16;
    RayPattern pattern = RayPattern::Sobol;

    static ParamTable describe() {
        using P = RayTracedParams;
        return fields(field(&P::samples, "samples")
                          .range(1, 256, Scale::Log)
                          .tune(1, 64)
                          .help("Rays per pixel to a light of some size: less noise in penumbrae for proportional "
                                "cost. Hard lights take "
                                "one ray."),
                      field(&P::pattern, "pattern")
                          .effect(ParamEffect::Define)
                          .help("How the rays spread over the light: independently, by Sobol points scrambled per "
                                "pixel, or by one Sobol set "
                                "rotated per pixel, whose noise is finer to the eye."));
    }
};

class RayTraced final : public ShadowTechniqueOf<RayTracedParams> {
public:
    void prepare(FrameContext&) override { m_rays.reset(); }

    void render(FrameContext& frame, const LightFrame& light, const gl::Texture& visibility) override {
        m_rays.draw(frame, *this, light, visibility, {.samples = p().samples});
    }

    std::uint64_t gpuBytes() const override { return m_rays.gpuBytes(); }

private:
    ShadowRays m_rays;
};

}  // namespace

OMBRAGE_TECHNIQUE(
    shadow, ray_traced, RayTraced,
    {.title = "Ray-traced shadows",
     .summary = "Rays from every visible point to the light, through a bounding volume hierarchy in storage buffers: "
                "exact for hard lights, sampled for soft ones.",
     .papers = {"whitted1980", "cook1984distributed", "smits1998", "woop2013watertight", "burley2020owen"},
     .limits =
         "The hierarchy is built on the CPU whenever the geometry changes; soft lights show noise that falls slowly "
         "with the number of rays.",
     .domain = {.soft = true},
     .usesSeed = true})

}  // namespace ombrage
