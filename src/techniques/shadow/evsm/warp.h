// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace ombrage::evsm {

/// The largest exponent c whose moment exp(c)^2 a float of so many bits holds, with a little room for sums.
inline double largestExponent(int bits) {
    const double largest = bits == 16 ? 65504.0 : 3.4028234e38;
    // To tenths, downwards.
    return std::floor(5.0 * std::log(largest)) / 10.0;
}

}  // namespace ombrage::evsm
