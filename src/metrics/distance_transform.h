// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace ombrage {

/// Exact Euclidean distance in pixels from each pixel's centre to the nearest marked one's; +inf where none is marked.
std::vector<float> distanceTransform(const std::vector<bool>& marked, int width, int height);

}  // namespace ombrage
