// SPDX-License-Identifier: MIT
#include "metrics/convolution.h"

#include <algorithm>

#include <tbb/parallel_for.h>

namespace ombrage {

Plane filterRows(const Plane& plane, const Kernel& kernel) {
    const int radius = int(kernel.size()) / 2, w = plane.width;
    Plane out(w, plane.height);
    tbb::parallel_for(0, plane.height, [&](int y) {
        // The row with its ends repeated, so that the inner loop has no condition.
        std::vector<float> padded(std::size_t(w + 2 * radius));
        const float* in = plane.row(y);
        for (int x = -radius; x < w + radius; ++x) padded[std::size_t(x + radius)] = in[std::clamp(x, 0, w - 1)];
        float* to = out.row(y);
        for (std::size_t k = 0; k < kernel.size(); ++k)
            for (int x = 0; x < w; ++x) to[x] += kernel[k] * padded[std::size_t(x) + k];
    });
    return out;
}

Plane filterColumns(const Plane& plane, const Kernel& kernel) {
    const int radius = int(kernel.size()) / 2, w = plane.width, h = plane.height;
    Plane out(w, h);
    tbb::parallel_for(0, h, [&](int y) {
        float* to = out.row(y);
        for (int k = -radius; k <= radius; ++k) {
            const float* from = plane.row(std::clamp(y + k, 0, h - 1));
            const float weight = kernel[std::size_t(k + radius)];
            for (int x = 0; x < w; ++x) to[x] += weight * from[x];
        }
    });
    return out;
}

}  // namespace ombrage
