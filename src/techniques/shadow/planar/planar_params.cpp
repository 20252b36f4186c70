// SPDX-License-Identifier: MIT
#include "techniques/shadow/planar/planar_params.h"

namespace ombrage::planar {

ParamTable Params::describe() {
    using P = Params;
    return fields(
        field(&P::receivers, "receivers")
            .effect(ParamEffect::Resize)
            .help("The flat surfaces found in the scene, floors first, or the one plane given by normal and offset."),
        field(&P::planes, "planes")
            .range(1, kMostPlanes)
            .effect(ParamEffect::Host)
            .help("How many of the planes found receive at most: fewer cost less, and what is left out has no "
                  "shadow."),
        field(&P::normal, "normal")
            .range(-1, 1)
            .effect(ParamEffect::Resize)
            .help("Across the given plane: three numbers that are not all 0, made unit."),
        field(&P::offset_m, "offset", Unit::Metre)
            .range(-1e6, 1e6)
            .effect(ParamEffect::Resize)
            .help("Distance of the given plane from the world's origin, along its normal."),
        field(&P::opacity, "opacity")
            .range(0, 1)
            .help("How much of the light a shadow takes: less than 1 is the half-transparent dark that the classical "
                  "method blends."),
        field(&P::style, "style")
            .effect(ParamEffect::Define)
            .help("What the shadow lets through: nothing, light of one tint, light coloured by the caster's own base "
                  "colour, or all of it between hatches."),
        field(&P::tint, "tint").range(0, 1).help("Colour of what a tinted shadow lets through, linear."),
        field(&P::hatch_m, "hatch", Unit::Metre)
            .range(0.001, 100, Scale::Log)
            .help("Distance from hatch to hatch of a hatched shadow; each is half as wide."),
        field(&P::blur, "blur")
            .effect(ParamEffect::Define)
            .help(
                "Of lights with a size: none, everywhere by one width, or as the light's size and the caster's height "
                "over the plane ask (contact). Lights of size 0 have hard shadows and no pass for a blur."),
        field(&P::width_m, "width", Unit::Metre)
            .range(0, 10)
            .tune(0.02, 1)
            .effect(ParamEffect::Host)
            .help("Diameter of the constant blur on the plane."),
        field(&P::width_px, "width-px", Unit::Pixel)
            .range(0, 128)
            .effect(ParamEffect::Host)
            .help("Diameter of the constant blur in the picture, in the place of `width` where it is over 0: as sharp "
                  "far away as it is near."),
        field(&P::samples, "samples")
            .range(8, 128)
            .tune(16, 128)
            .effect(ParamEffect::Define)
            .help("Points of the light that the blur asks: fewer leave steps in wide penumbrae."),
        field(&P::stencil, "stencil")
            .effect(ParamEffect::Host)
            .help("Every pixel darkens once. Off: every triangle blends, and darkens what another has darkened."),
        field(&P::limit, "limit")
            .effect(ParamEffect::Host)
            .help("Shadows stay on the surfaces of their plane. Off: they reach over its edges, in the air and on what "
                  "lies behind."),
        field(&P::clipLight, "clip-light")
            .effect(ParamEffect::Host)
            .help("Casters are cut at the light's height. Off: what is behind the light throws an anti-shadow."),
        field(&P::clipPlane, "clip-plane")
            .effect(ParamEffect::Host)
            .help("Casters are cut at the plane. Off: what is under it shades it."));
}

}  // namespace ombrage::planar
