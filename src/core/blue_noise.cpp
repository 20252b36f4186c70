// SPDX-License-Identifier: MIT
#include "core/blue_noise.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <random>

namespace ombrage {

namespace {

/// A pattern of ones on a torus, and how crowded every place is: a Gaussian about each one, summed (Ulichney 1993,
/// section 3).
class Pattern {
public:
    explicit Pattern(int size) : m_size(size), m_ones(cells(), 0), m_crowd(cells(), 0.0f), m_gaussian(cells()) {
        constexpr float kSigma_cells = 1.5f;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const int dx = std::min(x, size - x), dy = std::min(y, size - y);
                m_gaussian[at(x, y)] = std::exp(-float(dx * dx + dy * dy) / (2 * kSigma_cells * kSigma_cells));
            }
    }

    std::size_t cells() const { return std::size_t(m_size) * std::size_t(m_size); }
    bool isOne(std::size_t cell) const { return m_ones[cell] != 0; }

    void set(std::size_t cell, bool one) {
        m_ones[cell] = one ? 1 : 0;
        const float sign = one ? 1.0f : -1.0f;
        const int x0 = int(cell) % m_size, y0 = int(cell) / m_size;
        for (int y = 0; y < m_size; ++y) {
            const float* row = &m_gaussian[at(0, (y - y0 + m_size) % m_size)];
            float* crowd = &m_crowd[at(0, y)];
            for (int x = x0; x < m_size; ++x) crowd[x] += sign * row[x - x0];
            for (int x = 0; x < x0; ++x) crowd[x] += sign * row[x - x0 + m_size];
        }
    }

    /// The one that others crowd most, or the empty place that ones crowd least.
    std::size_t tightest() const { return extreme(true); }
    std::size_t emptiest() const { return extreme(false); }

private:
    std::size_t at(int x, int y) const { return std::size_t(y) * std::size_t(m_size) + std::size_t(x); }

    std::size_t extreme(bool ofOnes) const {
        std::size_t best = cells();
        for (std::size_t i = 0; i < cells(); ++i) {
            if (isOne(i) != ofOnes) continue;
            if (best == cells() || (ofOnes ? m_crowd[i] > m_crowd[best] : m_crowd[i] < m_crowd[best])) best = i;
        }
        return best;
    }

    int m_size;
    std::vector<std::uint8_t> m_ones;
    std::vector<float> m_crowd, m_gaussian;
};

/// A tenth of the places at random, moved from the tightest cluster to the largest void until that changes nothing.
Pattern startingPattern(int size, std::uint32_t seed) {
    Pattern pattern(size);
    std::mt19937 random(seed);
    std::size_t ones = 0;
    while (ones < std::max<std::size_t>(1, pattern.cells() / 10)) {
        const std::size_t cell = random() % pattern.cells();
        if (pattern.isOne(cell)) continue;
        pattern.set(cell, true);
        ++ones;
    }
    for (;;) {
        const std::size_t cluster = pattern.tightest();
        pattern.set(cluster, false);
        const std::size_t hole = pattern.emptiest();
        pattern.set(hole, true);
        if (hole == cluster) return pattern;
    }
}

}  // namespace

std::vector<std::uint32_t> blueNoise(int size, std::uint32_t seed) {
    assert(size >= 2 && size <= 256);
    const Pattern start = startingPattern(size, seed);
    std::vector<std::uint32_t> ranks(start.cells());
    std::uint32_t ones = 0;
    for (std::size_t i = 0; i < start.cells(); ++i) ones += start.isOne(i) ? 1 : 0;

    // Ranks of the starting ones, the most crowded last; then the places between them, the emptiest first. The paper
    // looks for clusters of zeros in its third phase, which are the voids of the ones.
    Pattern taken = start;
    for (std::uint32_t rank = ones; rank-- > 0;) {
        const std::size_t cell = taken.tightest();
        taken.set(cell, false);
        ranks[cell] = rank;
    }
    Pattern filled = start;
    for (std::uint32_t rank = ones; rank < ranks.size(); ++rank) {
        const std::size_t cell = filled.emptiest();
        filled.set(cell, true);
        ranks[cell] = rank;
    }
    return ranks;
}

}  // namespace ombrage
