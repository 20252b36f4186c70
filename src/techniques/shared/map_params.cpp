// SPDX-License-Identifier: MIT
#include "techniques/shared/map_params.h"

#include <algorithm>

namespace ombrage {

namespace {

GLenum culled(const MapParams& params) {
    if (params.cull == MapCull::Front) return GL_FRONT;
    if (params.cull == MapCull::Back) return GL_BACK;
    // Second-depth maps (Wang and Molnar 1994) hold the far sides of closed casters.
    return params.bias == MapBias::SecondDepth ? GL_FRONT : GL_NONE;
}

}  // namespace

LightDepth::Options MapParams::depthOptions() const {
    return {.resolution = resolution, .format = format, .fit = fit, .cull = culled(*this), .keep = cache};
}

ParamTable mapTable(const std::vector<ParamField>& own, bool fitted) {
    using P = MapParams;
    std::vector<ParamField> all = {
        field(&P::resolution, "resolution", Unit::Texel)
            .range(16, 8192, Scale::Log)
            .tune(256, 4096)
            .effect(ParamEffect::Resize)
            .help("Width and height of the map, or of each of a point light's: finer edges for more time and "
                  "memory."),
        field(&P::bias, "bias").effect(ParamEffect::Define).help("How a surface is kept from shadowing itself."),
        field(&P::constantBias_texels, "constant-bias", Unit::Texel)
            .range(0, 32)
            .tune(0, 4)
            .help("Distance towards the light, added in every mode: less acne, wider contact gaps."),
        field(&P::slopeBias_texels, "slope-bias", Unit::Texel)
            .range(0, 16)
            .tune(0, 4)
            .help("Distance per unit of slope (tangent of the light's angle to the normal), in mode slope."),
        field(&P::normalOffset_texels, "normal-offset", Unit::Texel)
            .range(0, 16)
            .tune(0, 4)
            .help("Shift along the normal times the sine of the light's angle to it, in mode normal-offset."),
        field(&P::maxSlope, "max-slope")
            .range(0, 100)
            .tune(1, 100)
            .help("Steepest slope that the biases follow: higher, less acne at grazing light; lower, fewer leaks."),
        field(&P::cull, "cull")
            .effect(ParamEffect::Host)
            .help("Which faces, seen from the light, stay out of the map: of closed meshes and of one-sided materials; "
                  "double-sided sheets keep both."),
        field(&P::format, "format")
            .effect(ParamEffect::Resize)
            .help("Bits of the stored depth: fewer take less memory and more bias, which is added by itself. A float's "
                  "serve any distance from a lamp."),
        field(&P::fit, "fit")
            .effect(ParamEffect::Host)
            .help("What a sun's map covers: all that casts, or the part that can shade what the camera sees (finer, "
                  "but it moves with the camera)."),
        field(&P::cache, "cache")
            .effect(ParamEffect::Host)
            .help("Keeps the map while neither the light nor the casters nor the fit changed.")};
    if (!fitted)
        all.erase(std::remove_if(all.begin(), all.end(), [](const ParamField& f) { return f.info.key == "fit"; }),
                  all.end());
    all.insert(all.end(), own.begin(), own.end());
    return ParamTable(std::move(all));
}

}  // namespace ombrage
