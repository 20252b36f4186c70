// SPDX-License-Identifier: MIT
// shadow/backprojection: the texels of a light's map, projected from the receiver onto the light.
#include "techniques/shared/soft_map.h"

namespace ombrage {

namespace {

/// Squares of each size along a side.
enum class SquaresAcross { Eight, Sixteen, ThirtyTwo, SixtyFour };
/// Between squares at different depths.
enum class SquareGaps { Closed, Open };

}  // namespace

template <>
struct EnumChoices<SquaresAcross> {
    static std::vector<std::string> names() { return {"8", "16", "32", "64"}; }
};
template <>
struct EnumChoices<SquareGaps> {
    static std::vector<std::string> names() { return {"closed", "open"}; }
};

namespace {

constexpr const char* kLookups = "lookups";

struct BackprojectionParams : SoftMapParams {
    SquaresAcross across = SquaresAcross::Sixteen;
    SquareGaps gaps = SquareGaps::Closed;

    BackprojectionParams() { maxRadius_texels = 96; }

    static ParamTable describe() {
        using P = BackprojectionParams;
        return mapTable(
            {field(&P::across, "max-texels")
                 .effect(ParamEffect::Host)
                 .help("Squares along a side that are looked at as single texels about the receiver; around them stand "
                       "as many of two texels, of four and so on: more make smoother penumbrae for more time."),
             field(&P::gaps, "gaps")
                 .effect(ParamEffect::Define)
                 .help("Between texels at different depths: closed, as one surface, or open, where light comes "
                       "through."),
             maxRadiusField(
                 P(),
                 "How far from the receiver's place in the map occluders are looked for; a light that needs more "
                 "counts as a smaller one. The six views of a point light overlap by as much, up to a quarter of "
                 "their width.")});
    }
};

class Backprojection final : public SoftMapTechniqueOf<BackprojectionParams> {
public:
    ShadowLookup lookup(FrameContext& frame, const LightFrame& light) override {
        const ShadowLookup lookup =
            lookUp(frame, light, "shadow/backprojection/backprojection.glsl", 0.5,
                   [this](const gl::Program& program) { program.set("u_across", 8 << int(p().across)); });
        show(frame, lookup, kLookups, "shadow/backprojection/show.frag");
        return lookup;
    }
};

}  // namespace

OMBRAGE_TECHNIQUE(
    shadow, backprojection, Backprojection,
    {.title = "Backprojection",
     .summary =
         "Every texel of a shadow map that lies between a point and the light is a small occluder: what they hide "
         "of the light, added up.",
     .papers = {"guennebaud2006backprojection"},
     .limits = "What several casters hide of the light is added up, so overlapping ones are too dark; what the light's "
               "centre does not see hides nothing.",
     .domain = {.rect = true, .soft = true},
     .passes = {{"light-depth", "depth seen from the light (the first of six views for a point light)"},
                {kLookups, "squares of the map that each pixel looks at"}}})

}  // namespace ombrage
