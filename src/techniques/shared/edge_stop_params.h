// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/param_table.h"

namespace ombrage {

/// What filters that keep surfaces apart have in common; shared/edge_stops.glsl takes it. Parameter structs derive from
/// it, with it as their only base, and put their own fields before it through edgeStopTable().
struct EdgeStopParams {
    float planeTolerance_px = 1.0f;
    float normalPower = 16.0f;
};

ParamTable edgeStopTable(std::vector<ParamField> own);

/// Of the bilateral filters.
struct BilateralParams : EdgeStopParams {
    int radius_px = 4;
    float sigma_px = 2.0f;

    static ParamTable describe();
};

}  // namespace ombrage
