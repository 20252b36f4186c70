// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <glm/glm.hpp>

namespace ombrage {

/// Points of the unit disk along the spiral of Vogel 1979: the k-th at the radius sqrt((k + 1/2) / count), each turned
/// by the golden angle from the one before.
std::vector<glm::vec2> vogelDisk(int count);

/// Points of the unit disk that keep apart: each the best of many random ones, the farthest from all before it
/// (Mitchell 1991). The same for the same count.
std::vector<glm::vec2> poissonDisk(int count);

}  // namespace ombrage
