// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

namespace ombrage {

/// Ranks 0 to size² - 1, each once, of a square that tiles, row by row: those below any rank are spread as evenly as
/// can be, so that neighbours differ and errors lie where an eye or a filter loses them. Void and cluster (Ulichney
/// 1993); the same seed gives the same square. Takes some 50 ms for a size of 64.
/// @param size  2 to 256
std::vector<std::uint32_t> blueNoise(int size, std::uint32_t seed);

}  // namespace ombrage
