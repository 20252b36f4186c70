// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <memory>
#include <random>

#include <ombrage/ao_integrand.h>

namespace ombrage::test {

/// An endless floor y = 0 and an endless wall x = distance, seen without perspective from above and from before the
/// wall; the receiver is the zero.
class FloorAndWall final : public AoProbe {
public:
    explicit FloorAndWall(double distance_m) : m_distance_m(distance_m) {}

    std::optional<double> distanceTo(const glm::dvec3&, double) const override { return {}; }

    std::optional<glm::dvec3> seenTowards(const glm::dvec3& offset) const override {
        const glm::dvec3 f = forward();
        return offset + f * std::min(-offset.y / f.y, (m_distance_m - offset.x) / f.x);
    }

    static AoReceiver receiver() {
        AoReceiver r;
        r.right = glm::normalize(glm::cross(forward(), glm::dvec3(0, 1, 0)));
        r.up = glm::cross(r.right, forward());
        r.sceneRadius_m = 1;
        r.sceneDiagonal_m = 100;
        return r;
    }

private:
    static glm::dvec3 forward() { return glm::normalize(glm::dvec3(0.6, -0.7, 0.4)); }

    const double m_distance_m;
};

/// A sheet across the sight before the eye that hides all the receiver's surroundings; the receiver faces the eye.
class SheetInFront final : public AoProbe {
public:
    explicit SheetInFront(double before_m) : m_before_m(before_m) {}

    std::optional<double> distanceTo(const glm::dvec3&, double) const override { return {}; }

    std::optional<glm::dvec3> seenTowards(const glm::dvec3& offset) const override {
        return glm::dvec3(offset.x, offset.y, m_before_m);
    }

    static AoReceiver receiver() {
        AoReceiver r;
        r.normal = r.shadingNormal = glm::dvec3(0, 0, 1);
        r.sceneRadius_m = 1;
        r.sceneDiagonal_m = 100;
        return r;
    }

private:
    const double m_before_m;
};

/// Mean of an integrand over random numbers. 200,000 of them leave a standard error of at most 0.0023 (values of 0 or
/// 2).
inline double meanOf(const AoIntegrand& integrand, const AoReceiver& receiver, const AoProbe& probe) {
    constexpr int kCount = 200000;
    std::mt19937 random(7);
    std::uniform_real_distribution<float> unit(0, 1);
    double sum = 0;
    for (int i = 0; i < kCount; ++i) {
        glm::vec4 u;
        for (int c = 0; c < 4; ++c) u[c] = unit(random);
        sum += integrand.sample(receiver, probe, u);
    }
    return sum / kCount;
}

/// Four standard errors of meanOf().
inline constexpr double kMeanTolerance = 0.01;

/// The share of a half ball of radius 1 that a wall at distance c cuts off: half of a ball's cap of height 1 - c.
inline double beyondWall(double c) {
    return (1 - c) * (1 - c) * (2 + c) / 4;
}

}  // namespace ombrage::test
