// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace ombrage {

/// One plane of numbers.
struct Plane {
    int width = 0, height = 0;
    std::vector<float> values;

    Plane() = default;
    Plane(int w, int h) : width(w), height(h), values(std::size_t(w) * std::size_t(h), 0.0f) {}
    float* row(int y) { return values.data() + std::size_t(y) * std::size_t(width); }
    const float* row(int y) const { return values.data() + std::size_t(y) * std::size_t(width); }
};

/// Weights of offsets -radius to radius; odd count.
using Kernel = std::vector<float>;

/// Correlation along one axis; beyond the border the nearest pixel goes on.
Plane filterRows(const Plane& plane, const Kernel& kernel);
Plane filterColumns(const Plane& plane, const Kernel& kernel);

}  // namespace ombrage
