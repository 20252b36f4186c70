// SPDX-License-Identifier: MIT
#pragma once

#include "techniques/shared/screen_ao.h"

namespace ombrage::starcraft2 {

struct Starcraft2Params : ScreenAoParams {
    int samples = 16;
    float full = 1.0f;
    float none = 2.0f;
    float power = 1.0f;
    float intensity = 1.0f;

    static ParamTable describe();
};

}  // namespace ombrage::starcraft2
