// SPDX-License-Identifier: MIT
#pragma once

#include "techniques/shared/screen_ao.h"

namespace ombrage::alchemy {

struct AlchemyParams : ScreenAoParams {
    int samples = 12;
    float intensity = 0.5f;
    float contrast = 1.0f;
    float bias = 1e-4f;
    float epsilon = 0.01f;

    static ParamTable describe();
};

}  // namespace ombrage::alchemy
