// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "core/hash.h"
#include "core/strings.h"
#include "lab/tune_search.h"

namespace ombrage::tuning {

/// The value's place in its range, in [0,1], on the range's scale. A value outside of the range is taken to its end.
inline double placeOf(const Dimension& d, double value) {
    value = std::clamp(value, d.minimum, d.maximum);
    if (d.maximum <= d.minimum) return 0;
    return d.logarithmic ? std::log(value / d.minimum) / std::log(d.maximum / d.minimum)
                         : (value - d.minimum) / (d.maximum - d.minimum);
}

/// The value at a place of the range, as a point may hold it: whole, or with four significant digits.
inline double valueAt(const Dimension& d, double place) {
    place = std::clamp(place, 0.0, 1.0);
    double value = d.logarithmic ? d.minimum * std::pow(d.maximum / d.minimum, place)
                                 : d.minimum + place * (d.maximum - d.minimum);
    if (d.kind == Dimension::Kind::Integer) return std::clamp(std::round(value), d.minimum, d.maximum);
    if (value != 0) {
        // In fixed steps near zero: there a linear range has digits that mean nothing.
        const double size = d.logarithmic ? std::abs(value) : std::max(std::abs(value), (d.maximum - d.minimum) / 100);
        const int exponent = int(std::floor(std::log10(size))) - 3;
        // Dividing by a power of ten that is whole gives the number that its decimal text reads back as.
        const double power = std::pow(10.0, std::abs(exponent));
        value = exponent < 0 ? std::round(value * power) / power : std::round(value / power) * power;
    }
    return std::clamp(value, d.minimum, d.maximum);
}

/// Numbers that are the same with every standard library (SplitMix64, Steele et al. 2014).
class Random {
public:
    explicit Random(std::uint64_t seed) : m_state(seed) {}
    std::uint64_t next() {
        m_state += 0x9e3779b97f4a7c15u;
        return mixedBits(m_state);
    }
    double unit() { return double(next() >> 11) * 0x1p-53; }
    template <typename T>
    void shuffle(std::vector<T>& values) {
        for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[std::size_t(next() % i)]);
    }

private:
    std::uint64_t m_state;
};

}  // namespace ombrage::tuning
