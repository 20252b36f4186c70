// SPDX-License-Identifier: MIT
#include "techniques/shadow/lvsm/layers.h"

#include <algorithm>
#include <limits>

namespace ombrage::lvsm {

namespace {

/// A bin that holds something.
struct Bin {
    double depth, count;
    std::size_t index;
};

/// Sums over the first bins, for the spread of any run of them.
class Spreads {
public:
    explicit Spreads(const std::vector<Bin>& bins) : m_sums(bins.size() + 1, glm::dvec3(0.0)) {
        for (std::size_t i = 0; i < bins.size(); ++i)
            m_sums[i + 1] = m_sums[i] + bins[i].count * glm::dvec3(1, bins[i].depth, bins[i].depth * bins[i].depth);
    }
    /// Sum of squared distances from their mean of the bins [from, to).
    double operator()(std::size_t from, std::size_t to) const {
        const glm::dvec3 sum = m_sums[to] - m_sums[from];
        return std::max(sum.z - sum.y * sum.y / sum.x, 0.0);
    }

private:
    std::vector<glm::dvec3> m_sums;
};

}  // namespace

std::vector<float> placeLayers(const std::vector<std::uint32_t>& histogram, int layers) {
    const double width = 2.0 / double(histogram.size());
    std::vector<Bin> bins;
    for (std::size_t i = 0; i < histogram.size(); ++i)
        if (histogram[i] > 0) bins.push_back({-1 + (double(i) + 0.5) * width, double(histogram[i]), i});
    const std::size_t count = std::min(std::size_t(layers), bins.size());
    if (count < 2) return {-1, 1};

    // best[k][j]: the least spread of the first j bins in k + 1 layers; first[k][j]: where the last of these begins.
    const Spreads spread(bins);
    const std::size_t n = bins.size();
    std::vector best(count, std::vector<double>(n + 1, std::numeric_limits<double>::infinity()));
    std::vector first(count, std::vector<std::size_t>(n + 1, 0));
    for (std::size_t j = 1; j <= n; ++j) best[0][j] = spread(0, j);
    for (std::size_t k = 1; k < count; ++k)
        for (std::size_t j = k + 1; j <= n; ++j)
            for (std::size_t i = k; i < j; ++i) {
                const double sum = best[k - 1][i] + spread(i, j);
                if (sum >= best[k][j]) continue;
                best[k][j] = sum;
                first[k][j] = i;
            }

    // Backwards, each end in the middle of the gap before the layer's first bin.
    std::vector<float> ends{1};
    for (std::size_t k = count - 1, j = n; k > 0; --k) {
        j = first[k][j];
        ends.push_back(float(0.5 * (bins[j - 1].depth + bins[j].depth)));
    }
    ends.push_back(-1);
    std::reverse(ends.begin(), ends.end());
    return ends;
}

std::vector<float> evenLayers(int layers) {
    std::vector<float> ends;
    for (int i = 0; i <= layers; ++i) ends.push_back(-1 + 2 * float(i) / float(layers));
    return ends;
}

std::vector<glm::vec4> layerSpans(const std::vector<float>& ends, float overlap, int count) {
    const std::size_t layers = ends.size() - 1;
    const auto depthOf = [&](std::size_t layer) { return ends[layer + 1] - ends[layer]; };
    std::vector<glm::vec4> spans;
    for (std::size_t i = 0; i < layers; ++i) {
        const float before = i > 0 ? overlap * std::min(depthOf(i - 1), depthOf(i)) : 0;
        const float after = i + 1 < layers ? overlap * std::min(depthOf(i), depthOf(i + 1)) : 0;
        spans.emplace_back(ends[i] - before, 1 / (depthOf(i) + before + after), ends[i + 1], 0);
    }
    // Nothing is as far as 2.
    spans.resize(std::size_t(count), glm::vec4(2, 1, 3, 0));
    return spans;
}

}  // namespace ombrage::lvsm
