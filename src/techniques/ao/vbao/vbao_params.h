// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "techniques/shared/ao_slices.h"

namespace ombrage::vbao {

/// How the sectors of a slice's mask spread over its angles.
enum class Sectors { Cosine, Uniform };

struct VbaoParams : AoSliceParams {
    float thickness_m = 0.25f;
    Sectors sectors = Sectors::Cosine;

    static ParamTable describe();
};

}  // namespace ombrage::vbao

namespace ombrage {

template <>
struct EnumChoices<vbao::Sectors> {
    static std::vector<std::string> names() { return {"cosine", "uniform"}; }
};

}  // namespace ombrage
