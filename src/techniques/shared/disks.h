// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "core/param_table.h"
#include "gl/objects.h"

namespace ombrage {

/// How a disk of points is turned from pixel to pixel (shared/disk_turn.glsl).
enum class DiskRotation { None, Interleaved, BlueNoise };

template <>
struct EnumChoices<DiskRotation> {
    static std::vector<std::string> names() { return {"none", "interleaved", "blue-noise"}; }
};

/// Points of the unit disk along the spiral of Vogel 1979: the k-th at the radius sqrt((k + 1/2) / count), each turned
/// by the golden angle from the one before.
std::vector<glm::vec2> vogelDisk(int count);

/// Points of the unit disk that keep apart: each the best of many random ones, the farthest from all before it
/// (Mitchell 1991). The same for the same count.
std::vector<glm::vec2> poissonDisk(int count);

/// Numbers of [0,1), spread as evenly as can be, for a texture unit of shared/disk_turn.glsl.
gl::Texture blueNoiseTexture();

}  // namespace ombrage
