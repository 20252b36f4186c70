// SPDX-License-Identifier: MIT
#pragma once

#include "techniques/shared/screen_ao.h"

namespace ombrage::ssdo {

struct SsdoParams : ScreenAoParams {
    int samples = 16;

    static ParamTable describe();
};

}  // namespace ombrage::ssdo
