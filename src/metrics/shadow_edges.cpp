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

/// Calls `found(i, j)` for every pair of neighbours, left to right and top to bottom, with an edge between them.
template <typename Found>
void eachCrossing(const ShadowTruth& truth, const Receivers& receivers, Found found) {
    const std::size_t w = std::size_t(truth.width), h = std::size_t(truth.height);
    const auto look = [&](std::size_t i, std::size_t step, bool before, bool after) {
        const std::size_t j = i + step;
        if (truth.mask[i] != Mask::Valid || truth.mask[j] != Mask::Valid) return;
        if (std::abs(truth.visibility[i] - truth.visibility[j]) <= 0.5f) return;
        if (continuous(receivers, i, step, before, after)) found(i, j);
    };
    for (std::size_t y = 0; y < h; ++y)
        for (std::size_t x = 0; x < w; ++x) {
            const std::size_t i = y * w + x;
            if (x + 1 < w) look(i, 1, x > 0, x + 2 < w);
            if (y + 1 < h) look(i, w, y > 0, y + 2 < h);
        }
}

/// Direction in which v* grows about pixel `i`, unit; 0 where it does not.
glm::dvec2 edgeNormal(const ShadowTruth& truth, std::size_t i) {
    constexpr int kRadius_px = 3;
    const int x = int(i % std::size_t(truth.width)), y = int(i / std::size_t(truth.width));
    glm::dvec2 gradient(0.0), offsets(0.0);
    double sum = 0, count = 0;
    for (int dy = -kRadius_px; dy <= kRadius_px; ++dy)
        for (int dx = -kRadius_px; dx <= kRadius_px; ++dx) {
            const int px = x + dx, py = y + dy;
            if (px < 0 || py < 0 || px >= truth.width || py >= truth.height) continue;
            const std::size_t j = std::size_t(py) * std::size_t(truth.width) + std::size_t(px);
            if (truth.mask[j] != Mask::Valid || dx * dx + dy * dy > kRadius_px * kRadius_px + 1) continue;
            const double v = double(truth.visibility[j]);
            gradient += v * glm::dvec2(dx, dy);
            offsets += glm::dvec2(dx, dy);
            sum += v;
            ++count;
        }
    // Where pixels are missing the window's middle is not its pixel.
    gradient -= offsets * (sum / count);
    const double length = glm::length(gradient);
    return length > 1e-9 ? gradient / length : glm::dvec2(0.0);
}

}  // namespace

std::vector<bool> hardEdges(const ShadowTruth& truth, const Receivers& receivers) {
    std::vector<bool> edge(truth.visibility.size(), false);
    eachCrossing(truth, receivers, [&](std::size_t i, std::size_t j) { edge[i] = edge[j] = true; });
    return edge;
}

double hardEdgeLength_px(const ShadowTruth& truth, const Receivers& receivers) {
    double length = 0;
    eachCrossing(truth, receivers, [&](std::size_t i, std::size_t j) {
        // Both sides are asked: the mean belongs to the border between them.
        const glm::dvec2 n = edgeNormal(truth, i) + edgeNormal(truth, j);
        const double size = glm::length(n);
        const bool isRow = j == i + 1;
        length += size > 0 ? std::abs(isRow ? n.x : n.y) / size : 1.0;
    });
    return length;
}

}  // namespace ombrage
