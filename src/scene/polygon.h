// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace ombrage {

/// Polygons with more corners than this are taken for convex: cutting ears takes the square of their number.
inline constexpr std::size_t kMostEars = 4096;

/// Cuts a polygon, concave ones too, into corners.size() - 2 triangles that keep its sense of rotation, and appends
/// their corners as indices into `corners`. Fewer than 3 corners give nothing. Polygons that are not flat are cut as
/// their projection along the mean normal; those that cross themselves, or with corners that are no numbers, give some
/// triangles of these corners.
void triangulate(std::span<const glm::vec3> corners, std::vector<std::uint32_t>& triangles);

}  // namespace ombrage
