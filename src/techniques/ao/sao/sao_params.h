// SPDX-License-Identifier: MIT
#pragma once

#include "techniques/shared/screen_ao.h"

namespace ombrage::sao {

struct SaoParams : ScreenAoParams {
    int samples = 11;
    int turns = 7;
    float intensity = 1.0f;
    float bias = 0.012f;
    float epsilon = 0.1f;
    bool mips = true;
    float mipOffset = 3.0f;

    static ParamTable describe();
};

}  // namespace ombrage::sao
