// SPDX-License-Identifier: MIT
// shadow/evsm: variance shadow maps of exponentially warped depth (Lauritzen 2008).
#include <algorithm>

#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/shadow/evsm/warp.h"
#include "techniques/shared/moment_technique.h"

namespace ombrage {
namespace {

enum class EvsmMoments { Two, Four };
enum class EvsmBits { Float32, Float16 };

}  // namespace

template <>
struct EnumChoices<EvsmMoments> {
    static std::vector<std::string> names() { return {"2", "4"}; }
};
template <>
struct EnumChoices<EvsmBits> {
    static std::vector<std::string> names() { return {"32f", "16f"}; }
};

namespace {

struct EvsmParams : VarianceMapParams {
    EvsmMoments moments = EvsmMoments::Four;
    EvsmBits bits = EvsmBits::Float32;
    float exponent = 42.0f;
    float negativeExponent = 5.0f;

    static ParamTable describe() {
        using P = EvsmParams;
        return varianceTable(
            {field(&P::moments, "moments")
                 .effect(ParamEffect::Define)
                 .help(
                     "2: of the positive warp alone, which lets light in where a receiver hides a farther surface; 4: "
                     "of the negative one, too, for twice the memory."),
             field(&P::bits, "bits")
                 .effect(ParamEffect::Define)
                 .help("Of each moment: 16f holds exponents up to 5.5, and larger ones count as that."),
             field(&P::exponent, "exponent")
                 .range(1, evsm::largestExponent(32))
                 .tune(5, evsm::largestExponent(32))
                 .help("Of the positive warp: larger, less light through casters in front of others."),
             field(&P::negativeExponent, "negative-exponent")
                 .range(1, evsm::largestExponent(32))
                 .tune(1, 20)
                 .help("Of the negative warp: larger, less light at the edges of receivers and more acne on curved "
                       "ones.")});
    }

    GLenum textureFormat() const {
        if (bits == EvsmBits::Float16) return moments == EvsmMoments::Four ? GL_RGBA16F : GL_RG16F;
        return moments == EvsmMoments::Four ? GL_RGBA32F : GL_RG32F;
    }
};

class ExponentialVariance final : public MomentTechniqueOf<EvsmParams> {
public:
    ShadowLookup lookup(FrameContext& frame, const LightFrame& light) override {
        const float largest = float(evsm::largestExponent(p().bits == EvsmBits::Float32 ? 32 : 16));
        const glm::vec2 exponents = glm::min(glm::vec2(p().exponent, p().negativeExponent), glm::vec2(largest));
        return lookUp(frame, light,
                      {.path = "shadow/evsm/evsm_moments.glsl",
                       .format = p().textureFormat(),
                       .read = {exponents.x, exponents.y},
                       .bind = [exponents](const gl::Program& program) { program.set("u_exponents", exponents); }},
                      "shadow/evsm/evsm.glsl");
    }
};

}  // namespace

OMBRAGE_TECHNIQUE(
    shadow, evsm, ExponentialVariance,
    {.title = "Exponential variance shadow map",
     .summary =
         "A variance shadow map of depths warped by exponentials, which pull far casters together and push light "
         "leaks out of sight.",
     .papers = {"lauritzen2008lvsm", "lauritzen2008thesis", "donnelly2006vsm"},
     .limits =
         "Contacts lose their shadow within the blur; with two moments receivers in front of farther surfaces are lit "
         "at shadows' edges.",
     .domain = {.rect = true, .soft = false},
     .passes = {{"light-depth", "depth seen from the light (the first of six views for a point light)"},
                {"moments", "the blurred mean of warped depth"}}})

}  // namespace ombrage
