// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/param_table.h"
#include "techniques/shared/light_depth.h"

namespace ombrage {

/// How a surface is kept from shadowing itself in a light's map.
enum class MapBias { Constant, Slope, NormalOffset, ReceiverPlane, Adaptive, Oriented, SecondDepth };
/// Which faces, seen from the light, stay out of the map.
enum class MapCull { None, Front, Back };

template <>
struct EnumChoices<MapBias> {
    static std::vector<std::string> names() {
        return {"constant", "slope", "normal-offset", "receiver-plane", "adaptive", "oriented", "second-depth"};
    }
};
template <>
struct EnumChoices<MapCull> {
    static std::vector<std::string> names() { return {"none", "front", "back"}; }
};
template <>
struct EnumChoices<LightFit> {
    static std::vector<std::string> names() { return {"scene", "view"}; }
};
template <>
struct EnumChoices<DepthFormat> {
    static std::vector<std::string> names() { return {"16", "24", "32f"}; }
};

/// What all techniques that compare with a light's map have in common; shared/map_point.glsl reads it. Parameter
/// structs derive from it, with it as their only base, and put their own fields through mapTable().
struct MapParams {
    int resolution = 1024;
    MapBias bias = MapBias::Adaptive;
    float constantBias_texels = 0.5f;
    float slopeBias_texels = 0.75f;
    float normalOffset_texels = 1.0f;
    float maxSlope = 40.0f;
    MapCull cull = MapCull::None;
    DepthFormat format = DepthFormat::Float32;
    LightFit fit = LightFit::Scene;
    bool cache = true;

    LightDepth::Options depthOptions() const;
};

/// Their declarations, followed by those of the technique. @param fitted false: of no sun, which `fit` is for
ParamTable mapTable(const std::vector<ParamField>& own = {}, bool fitted = true);

}  // namespace ombrage
