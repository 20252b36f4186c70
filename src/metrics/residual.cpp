// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <ombrage/error.h>
#include <tbb/parallel_for.h>

#include "metrics/image_metrics.h"

namespace ombrage {

namespace {

/// The window is 15 pixels wide: wider than the tiles of 4x4 that kernels turn in, and than the filters that remove
/// them.
constexpr int kRadius = 7;

/// Standard deviation that the truth may have in a flat window, beside its own noise.
constexpr double kFlat = 0.02;

struct Window {
    const AoTruth& truth;
    int x, y;

    template <typename F>
    void each(F&& f) const {
        for (int j = y - kRadius; j <= y + kRadius; ++j)
            for (int i = x - kRadius; i <= x + kRadius; ++i)
                f(std::size_t(j) * std::size_t(truth.width) + std::size_t(i));
    }

    /// Wholly valid, and the truth is of one value there.
    bool isFlat() const {
        if (x < kRadius || y < kRadius || x + kRadius >= truth.width || y + kRadius >= truth.height) return false;
        bool valid = true;
        double n = 0, sum = 0, squares = 0, noise = 0;
        each([&](std::size_t i) {
            valid = valid && truth.mask[i] == Mask::Valid;
            const double v = double(truth.visibility[i]);
            ++n;
            sum += v;
            squares += v * v;
            noise += double(truth.standardError[i]);
        });
        return valid && std::sqrt(std::max(squares / n - sum * sum / (n * n), 0.0)) <= kFlat + noise / n;
    }
};

}  // namespace

std::optional<double> residual(std::span<const float> visibility, const AoTruth& truth) {
    if (visibility.size() != truth.visibility.size())
        throw Error(ErrorCode::Usage, "the picture and its truth differ in size");
    struct Row {
        double squares = 0, count = 0;
    };
    std::vector<Row> rows(std::size_t(truth.height));
    tbb::parallel_for(0, truth.height, [&](int y) {
        Row& row = rows[std::size_t(y)];
        std::vector<float> values;
        for (int x = 0; x < truth.width; ++x) {
            const Window window{truth, x, y};
            if (!window.isFlat()) continue;
            values.clear();
            window.each([&](std::size_t i) { values.push_back(measuredValue(visibility[i], truth.visibility[i])); });
            const float here = values[values.size() / 2];
            const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
            std::nth_element(values.begin(), middle, values.end());
            const double d = double(here) - double(*middle);
            row.squares += d * d;
            ++row.count;
        }
    });
    Row all;
    for (const Row& row : rows) {
        all.squares += row.squares;
        all.count += row.count;
    }
    return all.count > 0 ? std::optional<double>(std::sqrt(all.squares / all.count)) : std::nullopt;
}

}  // namespace ombrage
