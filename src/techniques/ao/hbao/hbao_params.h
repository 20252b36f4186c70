// SPDX-License-Identifier: MIT
#pragma once

#include "techniques/shared/screen_ao.h"

namespace ombrage::hbao {

struct HbaoParams : ScreenAoParams {
    int directions = 8;
    int steps = 8;
    float angleBias_rad = 0.5235988f;  // 30 degrees
    bool jitter = true;

    static ParamTable describe();
};

}  // namespace ombrage::hbao
