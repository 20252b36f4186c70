// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <limits>

#include <ombrage/error.h>
#include <tbb/parallel_for.h>

#include "metrics/image_metrics.h"

namespace ombrage {
namespace {

constexpr int kRadius = 5;

std::array<double, 2 * kRadius + 1> gaussian() {
    std::array<double, 2 * kRadius + 1> w{};
    for (int i = -kRadius; i <= kRadius; ++i) w[std::size_t(i + kRadius)] = std::exp(-i * i / (2 * 1.5 * 1.5));
    return w;
}

/// Weighted sums of one window.
struct Sums {
    double weight = 0, a = 0, b = 0, aa = 0, bb = 0, ab = 0;
    void add(double w, const Sums& s) {
        weight += w * s.weight;
        a += w * s.a;
        b += w * s.b;
        aa += w * s.aa;
        bb += w * s.bb;
        ab += w * s.ab;
    }
};

/// Wang et al. 2004, equation 13, with range 1.
double similarity(const Sums& s) {
    constexpr double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;
    const double ma = s.a / s.weight, mb = s.b / s.weight;
    const double va = s.aa / s.weight - ma * ma, vb = s.bb / s.weight - mb * mb, cov = s.ab / s.weight - ma * mb;
    return ((2 * ma * mb + c1) * (2 * cov + c2)) / ((ma * ma + mb * mb + c1) * (va + vb + c2));
}

}  // namespace

std::vector<float> ssimMap(std::span<const float> a, std::span<const float> b, int width, int height,
                           const std::vector<Mask>& mask) {
    const std::size_t count = std::size_t(width) * std::size_t(height);
    if (a.size() != count || b.size() != count || (!mask.empty() && mask.size() != count))
        throw Error(ErrorCode::Usage, "images of different sizes have no structural similarity");
    const auto weights = gaussian();
    const auto valid = [&](std::size_t i) { return mask.empty() || mask[i] == Mask::Valid; };

    // Along the rows, over valid pixels only.
    std::vector<Sums> rows(count);
    tbb::parallel_for(0, height, [&](int y) {
        for (int x = 0; x < width; ++x) {
            Sums& sums = rows[std::size_t(y) * std::size_t(width) + std::size_t(x)];
            for (int d = std::max(-kRadius, -x); d <= std::min(kRadius, width - 1 - x); ++d) {
                const std::size_t i = std::size_t(y) * std::size_t(width) + std::size_t(x + d);
                if (!valid(i)) continue;
                const double p = double(a[i]), q = double(b[i]);
                sums.add(weights[std::size_t(d + kRadius)], {1, p, q, p * p, q * q, p * q});
            }
        }
    });

    // Along the columns. Windows lie inside the picture, as in the paper, unless it is smaller than one.
    std::vector<float> map(count, std::numeric_limits<float>::quiet_NaN());
    const bool inside = width > 2 * kRadius && height > 2 * kRadius;
    const int border = inside ? kRadius : 0;
    tbb::parallel_for(border, height - border, [&](int y) {
        for (int x = border; x < width - border; ++x) {
            const std::size_t i = std::size_t(y) * std::size_t(width) + std::size_t(x);
            if (!valid(i)) continue;
            Sums sums;
            for (int d = std::max(-kRadius, -y); d <= std::min(kRadius, height - 1 - y); ++d)
                sums.add(weights[std::size_t(d + kRadius)],
                         rows[std::size_t(y + d) * std::size_t(width) + std::size_t(x)]);
            map[i] = float(similarity(sums));
        }
    });
    return map;
}

std::optional<double> ssim(std::span<const float> a, std::span<const float> b, int width, int height,
                           const std::vector<Mask>& mask) {
    double sum = 0;
    std::size_t windows = 0;
    for (float s : ssimMap(a, b, width, height, mask))
        if (!std::isnan(s)) {
            sum += double(s);
            ++windows;
        }
    if (windows == 0) return std::nullopt;
    return sum / double(windows);
}

}  // namespace ombrage
