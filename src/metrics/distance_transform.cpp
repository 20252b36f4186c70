// SPDX-License-Identifier: MIT
#include "metrics/distance_transform.h"

#include <cmath>
#include <limits>

namespace ombrage {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

/// Lower envelope of the parabolas f(q) + (p - q)^2 at every p (Felzenszwalb and Huttenlocher 2012, algorithm 1).
void envelope(const std::vector<double>& f, std::vector<double>& d, int n) {
    std::vector<int> apex;     // of the parabolas in the envelope, left to right
    std::vector<double> from;  // where each begins
    for (int q = 0; q < n; ++q) {
        if (f[std::size_t(q)] == kFar) continue;
        double start = -kFar;
        // Drop the parabolas that the new one hides.
        while (!apex.empty()) {
            const double p = apex.back(), fp = f[std::size_t(apex.back())];
            start = ((f[std::size_t(q)] + double(q) * q) - (fp + p * p)) / (2.0 * (q - p));
            if (start > from.back()) break;
            apex.pop_back();
            from.pop_back();
            start = -kFar;
        }
        apex.push_back(q);
        from.push_back(start);
    }
    std::size_t k = 0;
    for (int p = 0; p < n; ++p) {
        while (k + 1 < apex.size() && from[k + 1] < p) ++k;
        d[std::size_t(p)] = apex.empty() ? kFar : f[std::size_t(apex[k])] + double(p - apex[k]) * (p - apex[k]);
    }
}

}  // namespace

std::vector<float> distanceTransform(const std::vector<bool>& marked, int width, int height) {
    const std::size_t w = std::size_t(width), h = std::size_t(height);
    std::vector<double> squared(w * h);
    std::vector<double> line(std::max(w, h)), out(std::max(w, h));
    // Columns, then rows.
    for (std::size_t x = 0; x < w; ++x) {
        for (std::size_t y = 0; y < h; ++y) line[y] = marked[y * w + x] ? 0 : kFar;
        envelope(line, out, height);
        for (std::size_t y = 0; y < h; ++y) squared[y * w + x] = out[y];
    }
    std::vector<float> distance(w * h);
    for (std::size_t y = 0; y < h; ++y) {
        for (std::size_t x = 0; x < w; ++x) line[x] = squared[y * w + x];
        envelope(line, out, width);
        for (std::size_t x = 0; x < w; ++x) distance[y * w + x] = float(std::sqrt(out[x]));
    }
    return distance;
}

}  // namespace ombrage
