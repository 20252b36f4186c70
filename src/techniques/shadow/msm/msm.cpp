// SPDX-License-Identifier: MIT
// shadow/msm: moment shadow maps (Peters, Klein 2015).
#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/shadow/msm/quantisation.h"
#include "techniques/shared/moment_technique.h"

namespace ombrage {
namespace {

enum class MsmReconstruction { Hamburger, Hausdorff };

}  // namespace

template <>
struct EnumChoices<MsmReconstruction> {
    static std::vector<std::string> names() { return {"hamburger", "hausdorff"}; }
};

namespace {

struct MsmParams : MomentMapParams {
    MsmReconstruction reconstruction = MsmReconstruction::Hamburger;
    MomentBits bits = MomentBits::Unorm16;
    float momentBias = 1.0f;
    float spreadBias = 0.25f;

    MsmParams() { bleeding = 0.02f; }

    static ParamTable describe() {
        using P = MsmParams;
        return momentTable(
            {field(&P::reconstruction, "reconstruction")
                 .effect(ParamEffect::Define)
                 .help("What is known of the depths: hamburger, nothing; hausdorff, that they lie in the map's range: "
                       "less light through casters, more acne."),
             field(&P::bits, "bits")
                 .effect(ParamEffect::Define)
                 .help("Of each of the four moments: 16 keeps them turned and stretched so that rounding costs least."),
             field(&P::momentBias, "moment-bias")
                 .range(0, 100)
                 .tune(0.25, 8)
                 .help("In units of what rounding to the format needs: more, less noise and more light through "
                       "overlapping casters."),
             field(&P::spreadBias, "spread-bias")
                 .range(0, 8)
                 .tune(0, 2)
                 .help("Bias for each unit of slope, in standard deviations of the whole filter: more, less acne and "
                       "more light at contacts.")},
            MsmParams());
    }
};

glm::vec4 rows(const glm::dvec2& first, const glm::dvec2& second) {
    return glm::vec4(glm::vec2(first), glm::vec2(second));
}

void bindQuantisation(const gl::Program& program) {
    static const msm::Quantisation kForm = msm::quantisation();
    static const glm::dmat2 kOddBack = msm::inverseRows(kForm.odd), kEvenBack = msm::inverseRows(kForm.even);
    program.set("u_odd", rows(kForm.odd[0], kForm.odd[1]));
    program.set("u_even", rows(kForm.even[0], kForm.even[1]));
    program.set("u_oddBack", rows(kOddBack[0], kOddBack[1]));
    program.set("u_evenBack", rows(kEvenBack[0], kEvenBack[1]));
}

class MomentShadowMap final : public MomentTechniqueOf<MsmParams> {
public:
    ShadowLookup lookup(FrameContext& frame, const LightFrame& light) override {
        const bool isFloat = p().bits == MomentBits::Float32;
        return lookUp(frame, light,
                      {.path = "shadow/msm/msm_moments.glsl",
                       .format = GLenum(isFloat ? GL_RGBA32F : GL_RGBA16),
                       .bind = isFloat ? std::function<void(const gl::Program&)>() : bindQuantisation},
                      "shadow/msm/msm.glsl");
    }
};

}  // namespace

OMBRAGE_TECHNIQUE(
    shadow, msm, MomentShadowMap,
    {.title = "Moment shadow map",
     .summary =
         "Four moments of the depths under a filter give the sharpest bound on the share of them that is lit: exact up "
         "to two depths, in 64 bits a texel.",
     .papers = {"peters2015msm"},
     .limits =
         "Light comes through where more than two depths lie under the filter; the blur has one width, and contacts "
         "lose their shadow within it.",
     .domain = {.rect = true, .soft = false},
     .passes = {{"light-depth", "depth seen from the light (the first of six views for a point light)"},
                {"moments", "the blurred moments of depth"}}})

}  // namespace ombrage
