// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <glm/glm.hpp>

namespace ombrage {

/// Number of dimensions of the Sobol sequence here.
inline constexpr int kSobolDimensions = 4;

/// Point `index` of the Sobol sequence in dimension `dimension` (0 to 3; direction numbers of Joe and Kuo 2008), as 32 bits.
std::uint32_t sobol(std::uint32_t index, int dimension);

/// Owen's nested uniform scrambling by hash (Laine and Karras 2011 with the constants of Burley 2020, "Practical hash-based
/// Owen scrambling", JCGT 9:4). Equal seeds give equal scramblings.
std::uint32_t owenScramble(std::uint32_t bits, std::uint32_t seed);

/// Owen-scrambled, shuffled Sobol point in [0,1)^2. `dimensionPair` 0 uses dimensions 0 and 1, pair 1 dimensions 2 and 3;
/// further pairs reuse them with another shuffle (Burley's padding).
glm::vec2 owenSobol2(std::uint32_t index, std::uint32_t seed, int dimensionPair = 0);

/// Integer hash with good avalanche, for seeds.
std::uint32_t hashCombine(std::uint32_t a, std::uint32_t b);

}  // namespace ombrage
