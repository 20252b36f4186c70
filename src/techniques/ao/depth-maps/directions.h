// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <glm/glm.hpp>

namespace ombrage::depth_maps {

/// Unit directions spread evenly over the sphere: heights of equal steps, each turned by the golden angle from the one
/// before (spherical Fibonacci points, Swinbank and Purser 2006; as samples of integrals Marques et al. 2013).
std::vector<glm::vec3> evenDirections(int count);

}  // namespace ombrage::depth_maps
