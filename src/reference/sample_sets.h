// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "reference/ray_scene.h"

namespace ombrage {

/// Samples of one bundle in polar form: u in [0,1) and a point of the unit circle.
struct PolarSamples {
    alignas(64) std::array<float, RayBundle::kSize> u{}, cosine{}, sine{};
};

/// Samples of one bundle in the unit square.
struct SquareSamples {
    alignas(64) std::array<float, RayBundle::kSize> u{}, v{};
};

/// The points of kScramblings independent Owen scramblings of the Sobol sequence, made once for a picture. A receiver
/// moves every scrambling by random bits of its own, which leaves a (0,m,2)-net a net: u by exclusive or (Kollig and
/// Keller 2002), v likewise, or as an angle by a turn (Cranley and Patterson 1976). Any one point is then even in the
/// square, the scramblings stay independent, and a sample costs a few instructions instead of three scramblings.
class SampleSets {
public:
    /// @param samples per scrambling, above 0
    SampleSets(std::uint32_t seed, int samples);

    int samples() const { return m_samples; }
    int bundles() const { return (m_samples + RayBundle::kSize - 1) / RayBundle::kSize; }

    /// One bit for each sample of the bundle.
    std::uint32_t wanted(int bundle) const;

    /// How one receiver moves one scrambling.
    struct Move {
        std::uint32_t u = 0, v = 0;
        float cosine = 1, sine = 0;  ///< of the turn
    };
    static Move moveOf(std::uint32_t pointSeed, int scrambling);

    void polar(int scrambling, int bundle, const Move& move, PolarSamples& samples) const;
    void square(int scrambling, int bundle, const Move& move, SquareSamples& samples) const;

private:
    std::size_t first(int scrambling, int bundle) const;

    int m_samples;
    std::vector<std::uint32_t> m_u, m_v;  ///< per scrambling, whole bundles
    std::vector<float> m_cosine, m_sine;  ///< of 2 pi v
};

}  // namespace ombrage
