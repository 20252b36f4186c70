// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

namespace ombrage {

/// Per vertex the first one at the same position, which is itself for most. Coordinates must be equal to the bit, but
/// that -0 is 0; a position that is no number equals none. Linear time.
std::vector<std::uint32_t> weldedVertices(const std::vector<glm::vec3>& positions);

}  // namespace ombrage
