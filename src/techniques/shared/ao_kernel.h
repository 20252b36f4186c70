// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "core/param_table.h"

namespace ombrage {

enum class AoOffsets { Screen, Hemisphere };
enum class AoDistribution { Uniform, Cosine, Importance };

/// The sample offsets of one pixel, before its rotation about z. xyz lies in the unit disk z = 0 (screen) or in the
/// upper half of the unit ball (hemisphere, z along the normal); w is the sample's weight, which is 1 on the average
/// over the distribution.
///
/// - uniform: even in the disk's area, or in the half ball's volume;
/// - cosine: directions cosine-weighted and lengths t with density 2 t, or the shadow of such points on the disk, so
///   that density grows towards the receiver as ln(1 / rho);
/// - importance: the integral of `uniform`, with points put where the estimator's weights are large and divided by
///   their density (on the half ball by a mixture whose weights stay below 2.1).
std::vector<glm::vec4> aoKernel(AoOffsets offsets, AoDistribution distribution, int count);

/// Points even in the unit ball (w is 1), before their reflection from pixel to pixel.
std::vector<glm::vec4> aoBallKernel(int count);

}  // namespace ombrage

namespace ombrage {

template <>
struct EnumChoices<AoOffsets> {
    static std::vector<std::string> names() { return {"screen", "hemisphere"}; }
};

template <>
struct EnumChoices<AoDistribution> {
    static std::vector<std::string> names() { return {"uniform", "cosine", "importance"}; }
};

}  // namespace ombrage
