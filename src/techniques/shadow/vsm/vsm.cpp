// SPDX-License-Identifier: MIT
// shadow/vsm: variance shadow maps (Donnelly, Lauritzen 2006).
#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/shared/moment_technique.h"

namespace ombrage {
namespace {

struct VsmParams : VarianceMapParams {
    MomentBits bits = MomentBits::Float32;

    VsmParams() { bleeding = 0.2f; }

    static ParamTable describe() {
        using P = VsmParams;
        return varianceTable(
            {field(&P::bits, "bits")
                 .effect(ParamEffect::Define)
                 .help(
                     "Of each of the two moments: fewer take less memory and need more least deviation, which is added "
                     "by itself.")},
            VsmParams());
    }
};

class VarianceShadowMap final : public MomentTechniqueOf<VsmParams> {
public:
    ShadowLookup lookup(FrameContext& frame, const LightFrame& light) override {
        return lookUp(frame, light,
                      {.path = "shadow/vsm/vsm_moments.glsl",
                       .format = GLenum(p().bits == MomentBits::Float32 ? GL_RG32F : GL_RG16)},
                      "shadow/vsm/vsm.glsl");
    }
};

}  // namespace

OMBRAGE_TECHNIQUE(
    shadow, vsm, VarianceShadowMap,
    {.title = "Variance shadow map",
     .summary =
         "Mean and mean square of the depths under a filter bound the share of them that is lit: a map that may be "
         "blurred and mipmapped beforehand.",
     .papers = {"donnelly2006vsm", "lauritzen2007gems3"},
     .limits =
         "Light comes through where casters overlap; the blur has one width, and contacts lose their shadow within it.",
     .domain = {.rect = true, .soft = false},
     .passes = {{"light-depth", "depth seen from the light (the first of six views for a point light)"},
                {"moments", "the blurred mean of depth"}}})

}  // namespace ombrage
