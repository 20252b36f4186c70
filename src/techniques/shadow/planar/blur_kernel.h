// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <glm/glm.hpp>

namespace ombrage::planar {

/// Points of the unit disk on Vogel's spiral: xy even in area, zw with radii that grow with the square of the index, for a
/// search that must find both wide and narrow half-shadows; the first zw is the centre.
std::vector<glm::vec4> blurKernel(int samples);

}  // namespace ombrage::planar
