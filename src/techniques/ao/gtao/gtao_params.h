// SPDX-License-Identifier: MIT
#pragma once

#include "techniques/shared/ao_slices.h"

namespace ombrage::gtao {

struct GtaoParams : AoSliceParams {
    float falloff = 0.0f;
    float thickness = 0.0f;
    bool multiBounce = false;

    static ParamTable describe();
};

}  // namespace ombrage::gtao
