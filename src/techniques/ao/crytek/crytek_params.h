// SPDX-License-Identifier: MIT
#pragma once

#include "techniques/shared/screen_ao.h"

namespace ombrage::crytek {

struct CrytekParams : ScreenAoParams {
    int pairs = 16;
    float range = 1.0f;
    bool remap = true;

    static ParamTable describe();
};

}  // namespace ombrage::crytek
