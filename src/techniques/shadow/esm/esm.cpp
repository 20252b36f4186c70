// SPDX-License-Identifier: MIT
// shadow/esm: exponential shadow maps (Annen, Mertens, Seidel, Flerackers, Kautz 2008).
#include <algorithm>

#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/shared/moment_technique.h"

namespace ombrage {
namespace {

/// What is stored and blurred: exponentials of depth, or their logarithms.
enum class EsmSpace { Log, Exp };

/// A float ends at exp(88.7); the rest is room for sums.
constexpr float kLargestExponent = 87.0f;

}  // namespace

template <>
struct EnumChoices<EsmSpace> {
    static std::vector<std::string> names() { return {"log", "exp"}; }
};

namespace {

struct EsmParams : MomentMapParams {
    EsmSpace space = EsmSpace::Log;
    float exponent = 100.0f;

    EsmParams() { bleeding = 0.1f; }

    static ParamTable describe() {
        using P = EsmParams;
        return momentTable(
            {field(&P::space, "space")
                 .effect(ParamEffect::Define)
                 .help("log: the blur sums exponentials and stores the logarithm, for any exponent. exp: as in the "
                       "paper, for exponents up to 87, and larger ones count as that."),
             field(&P::exponent, "exponent")
                 .range(1, 2000, Scale::Log)
                 .tune(40, 400)
                 .help("Sharpness over half the range of depths: larger, less light near contacts, and "
                       "more where the light grazes.")},
            EsmParams());
    }
};

class ExponentialShadowMap final : public MomentTechniqueOf<EsmParams> {
public:
    ShadowLookup lookup(FrameContext& frame, const LightFrame& light) override {
        const bool isLog = p().space == EsmSpace::Log;
        const float exponent = isLog ? p().exponent : std::min(p().exponent, kLargestExponent);
        return lookUp(frame, light,
                      {.path = "shadow/esm/esm_moments.glsl",
                       .format = GL_R32F,
                       .read = {exponent},
                       .bind = [exponent](const gl::Program& program) { program.set("u_exponent", exponent); },
                       .logarithmic = isLog},
                      "shadow/esm/esm.glsl");
    }
};

}  // namespace

OMBRAGE_TECHNIQUE(
    shadow, esm, ExponentialShadowMap,
    {.title = "Exponential shadow map",
     .summary =
         "The comparison of depths as a product of two exponentials, of which the map's is blurred beforehand: one "
         "number per texel.",
     .papers = {"annen2008esm", "lauritzen2008thesis"},
     .limits = "Shadows fade near their casters, and receivers in front of farther surfaces are lit at shadows' edges.",
     .domain = {.rect = true, .soft = false},
     .passes = {{"light-depth", "depth seen from the light (the first of six views for a point light)"},
                {"moments", "what the map stores, blurred"}}})

}  // namespace ombrage
