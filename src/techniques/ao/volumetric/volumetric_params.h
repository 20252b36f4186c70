// SPDX-License-Identifier: MIT
#pragma once

#include "techniques/shared/screen_ao.h"

namespace ombrage::volumetric {

enum class Sampling { Points, Lines, Areas };
/// What an area's mean and variance stand for.
enum class Depths { Normal, Steps };

struct VolumetricParams : ScreenAoParams {
    Sampling sampling = Sampling::Lines;
    int samples = 9;
    Depths depths = Depths::Steps;
    bool clip = true;
    float thickness = 0.0f;

    static ParamTable describe();
};

}  // namespace ombrage::volumetric

namespace ombrage {

template <>
struct EnumChoices<volumetric::Sampling> {
    static std::vector<std::string> names() { return {"points", "lines", "areas"}; }
};

template <>
struct EnumChoices<volumetric::Depths> {
    static std::vector<std::string> names() { return {"normal", "steps"}; }
};

}  // namespace ombrage
