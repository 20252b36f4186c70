// SPDX-License-Identifier: MIT
#pragma once

#include "techniques/ao/blocks/kernel.h"

namespace ombrage::blocks {

enum class Rotation { None, Gradient, Hash, Tile };

struct BlocksParams {
    int samples = 32;
    Offsets offsets = Offsets::Screen;
    Distribution kernel = Distribution::Cosine;
    Rotation rotation = Rotation::Gradient;
    float radius_m = 0.0f;
    float intensity = 7.0f;
    float angle_rad = 1.2217305f;  // 70 degrees
    float bias_m = 0.0f;

    static ParamTable describe();
};

}  // namespace ombrage::blocks

namespace ombrage {

template <>
struct EnumChoices<blocks::Rotation> {
    static std::vector<std::string> names() { return {"none", "gradient", "hash", "tile"}; }
};

}  // namespace ombrage
