// SPDX-License-Identifier: MIT
#pragma once

#include "techniques/ao/blocks/kernel.h"
#include "techniques/shared/screen_ao.h"

namespace ombrage::blocks {

struct BlocksParams : ScreenAoParams {
    int samples = 32;
    Offsets offsets = Offsets::Screen;
    Distribution kernel = Distribution::Cosine;
    float intensity = 7.0f;
    float angle_rad = 1.2217305f;  // 70 degrees
    float bias_m = 0.0f;

    static ParamTable describe();
};

}  // namespace ombrage::blocks
