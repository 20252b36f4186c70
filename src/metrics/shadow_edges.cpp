// SPDX-License-Identifier: MIT
#include "metrics/shadow_edges.h"

#include <algorithm>
#include <cmath>

namespace ombrage {
namespace {

/// Whether the distance runs on from pixel `i` to `i + step` without a jump: it changes by no more than twice the slope
/// on either side and a few pixels. `before` and `after` tell whether the pixels beyond the pair are in the picture.
bool continuous(const Receivers& r, std::size_t i, std::size_t step, bool before, bool after) {
    const std::size_t j = i + step;
    const double jump = std::abs(double(r.distance_m[j]) - double(r.distance_m[i]));
    double slope = 0;
    if (before && r.triangle[i - step] != kNoHit)
        slope = std::max(slope, std::abs(double(r.distance_m[i]) - double(r.distance_m[i - step])));
    if (after && r.triangle[j + step] != kNoHit)
        slope = std::max(slope, std::abs(double(r.distance_m[j + step]) - double(r.distance_m[j])));
    return jump <= 2 * slope + 4 * std::max(double(r.pixelSize_m[i]), double(r.pixelSize_m[j]));
}

}  // namespace

std::vector<bool> hardEdges(const ShadowTruth& truth, const Receivers& receivers) {
    const std::size_t w = std::size_t(truth.width), h = std::size_t(truth.height);
    std::vector<bool> edge(w * h, false);
    const auto mark = [&](std::size_t i, std::size_t step, bool before, bool after) {
        const std::size_t j = i + step;
        if (truth.mask[i] != Mask::Valid || truth.mask[j] != Mask::Valid) return;
        if (std::abs(truth.visibility[i] - truth.visibility[j]) <= 0.5f) return;
        if (continuous(receivers, i, step, before, after)) edge[i] = edge[j] = true;
    };
    for (std::size_t y = 0; y < h; ++y)
        for (std::size_t x = 0; x < w; ++x) {
            const std::size_t i = y * w + x;
            if (x + 1 < w) mark(i, 1, x > 0, x + 2 < w);
            if (y + 1 < h) mark(i, w, y > 0, y + 2 < h);
        }
    return edge;
}

}  // namespace ombrage
