// SPDX-License-Identifier: MIT
#include "reference/sample_sets.h"

#include <cmath>

#include <ombrage/reference.h>

#include "core/sobol.h"

namespace ombrage {
namespace {

constexpr double kTwoPi = 6.28318530717958647693;

/// The upper 24 bits as a float below 1.
inline float unitFloat(std::uint32_t bits) {
    return float(std::int32_t(bits >> 8)) * 0x1p-24f;
}

}  // namespace

SampleSets::SampleSets(std::uint32_t seed, int samples) : m_samples(samples) {
    const std::size_t perScrambling = std::size_t(bundles()) * RayBundle::kSize;
    for (int k = 0; k < kScramblings; ++k) {
        const std::uint32_t scrambling = hashCombine(seed, std::uint32_t(k));
        for (std::size_t i = 0; i < perScrambling; ++i) {
            const glm::vec2 point = owenSobol2(std::uint32_t(i), scrambling);
            // 24 bits are all that a float of [0,1) holds; those below are as good as any.
            m_u.push_back(std::uint32_t(point.x * 0x1p24f) << 8);
            m_v.push_back(std::uint32_t(point.y * 0x1p24f) << 8);
            m_cosine.push_back(float(std::cos(kTwoPi * double(point.y))));
            m_sine.push_back(float(std::sin(kTwoPi * double(point.y))));
        }
    }
}

std::size_t SampleSets::first(int scrambling, int bundle) const {
    return (std::size_t(scrambling) * std::size_t(bundles()) + std::size_t(bundle)) * RayBundle::kSize;
}

std::uint32_t SampleSets::wanted(int bundle) const {
    const int left = m_samples - bundle * RayBundle::kSize;
    return left >= RayBundle::kSize ? 0xffffu : (1u << left) - 1u;
}

SampleSets::Move SampleSets::moveOf(std::uint32_t pointSeed, int scrambling) {
    Move move;
    move.u = hashCombine(pointSeed, std::uint32_t(scrambling));
    move.v = hashCombine(move.u, pointSeed);
    const double turn = kTwoPi * double(unitFloat(move.v));
    move.cosine = float(std::cos(turn));
    move.sine = float(std::sin(turn));
    return move;
}

void SampleSets::polar(int scrambling, int bundle, const Move& move, PolarSamples& samples) const {
    const std::size_t start = first(scrambling, bundle);
    const std::uint32_t* u = &m_u[start];
    const float *cosine = &m_cosine[start], *sine = &m_sine[start];
    for (std::size_t i = 0; i < RayBundle::kSize; ++i) {
        samples.u[i] = unitFloat(u[i] ^ move.u);
        samples.cosine[i] = cosine[i] * move.cosine - sine[i] * move.sine;
        samples.sine[i] = sine[i] * move.cosine + cosine[i] * move.sine;
    }
}

void SampleSets::square(int scrambling, int bundle, const Move& move, SquareSamples& samples) const {
    const std::size_t start = first(scrambling, bundle);
    for (std::size_t i = 0; i < RayBundle::kSize; ++i) {
        samples.u[i] = unitFloat(m_u[start + i] ^ move.u);
        samples.v[i] = unitFloat(m_v[start + i] ^ move.v);
    }
}

}  // namespace ombrage
