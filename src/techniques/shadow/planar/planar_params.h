// SPDX-License-Identifier: MIT
#pragma once

#include "core/param_table.h"
#include "scene/planar_surfaces.h"

namespace ombrage {

namespace planar {

/// Which planes receive.
enum class Source { Found, Given };
/// What a shadow does to the light that it takes.
enum class Style { Plain, Tinted, Textured, Hatched };
/// How the edge of the shadow of a light with a size is blurred.
enum class Blur { Off, Constant, Contact };

inline constexpr int kMostPlanes = int(1 / kLeastPlanarShare);

struct Params {
    Source receivers = Source::Found;
    int planes = kMostPlanes;
    glm::vec3 normal{0, 1, 0};
    float offset_m = 0;
    float opacity = 1;
    Style style = Style::Plain;
    glm::vec3 tint{0.05f, 0.1f, 0.35f};
    float hatch_m = 0.1f;
    Blur blur = Blur::Contact;
    float width_m = 0.2f;
    float width_px = 0;
    int samples = 32;
    bool stencil = true;
    bool limit = true;
    bool clipLight = true;
    bool clipPlane = true;

    static ParamTable describe();
};

}  // namespace planar

template <>
struct EnumChoices<planar::Source> {
    static std::vector<std::string> names() { return {"found", "given"}; }
};
template <>
struct EnumChoices<planar::Style> {
    static std::vector<std::string> names() { return {"plain", "tinted", "textured", "hatched"}; }
};
template <>
struct EnumChoices<planar::Blur> {
    static std::vector<std::string> names() { return {"off", "constant", "contact"}; }
};

}  // namespace ombrage
