// SPDX-License-Identifier: MIT
#pragma once

#include "core/param_table.h"

namespace ombrage {

/// The farthest occluder as techniques that work in the scene itself are asked for it. Parameter structs derive from
/// it, with it as their only base, and declare aoRadiusField() and aoRadiusPercentField().
struct AoRadius {
    float radius_m = 0.0f;
    float radiusPercent = 0.0f;

    /// `radius`, else `radius-percent` of the scene's diagonal, else the scene's own.
    double radiusIn(double sceneRadius_m, double sceneDiagonal_m) const {
        if (radius_m > 0) return double(radius_m);
        return radiusPercent > 0 ? 0.01 * double(radiusPercent) * sceneDiagonal_m : sceneRadius_m;
    }
};

inline ParamField aoRadiusField() {
    return field(&AoRadius::radius_m, "radius", Unit::Metre)
        .range(0, 100)
        .effect(ParamEffect::Host)
        .help("Farthest occluder; 0 takes radius-percent.");
}

inline ParamField aoRadiusPercentField() {
    return field(&AoRadius::radiusPercent, "radius-percent")
        .range(0, 100)
        .effect(ParamEffect::Host)
        .help("The same in percent of the scene's diagonal; 0 takes the scene's ao_radius_m.");
}

}  // namespace ombrage
