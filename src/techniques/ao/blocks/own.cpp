// SPDX-License-Identifier: MIT
#include "techniques/ao/blocks/own.h"

#include <algorithm>
#include <cmath>

namespace ombrage::blocks {

namespace {

constexpr double kTwoPi = 6.28318530717958647693;

class BlocksIntegrand final : public AoIntegrand {
public:
    explicit BlocksIntegrand(const BlocksParams& params) : m_params(params), m_cosAngle(std::cos(params.angle_rad)) {}

    double sample(const AoReceiver& receiver, const AoProbe& probe, const glm::vec4& u) const override {
        const double radius_m = m_params.radiusIn(receiver.sceneRadius_m, receiver.sceneDiagonal_m);
        const auto found = probe.seenTowards(offset(receiver, u) * radius_m);
        if (!found) return 1;

        // The weight of the surface found, from the lifted receiver.
        const glm::dvec3 d = *found - receiver.shadingNormal * double(m_params.bias_m);
        const double distance_m = glm::length(d);
        if (distance_m <= 0) return 1;
        const double near = std::max(0.0, 1 - distance_m * distance_m / (radius_m * radius_m));
        const double rise = std::max(0.0, glm::dot(receiver.shadingNormal, d) / distance_m - m_cosAngle);
        return 1 - double(m_params.intensity) * near * rise;
    }

private:
    /// A point of the kernel's distribution in units of the radius. Importance sampling has the integral of `uniform`.
    glm::dvec3 offset(const AoReceiver& receiver, const glm::vec4& u) const {
        const bool isCosine = m_params.kernel == Distribution::Cosine;
        const double phi = kTwoPi * double(u.y);
        if (m_params.offsets == Offsets::Screen) {
            // Even in the disk; or the shadow of cosine-weighted directions (sine^2 even) with lengths of density 2t.
            const double rho = std::sqrt(isCosine ? double(u.x) * double(u.z) : double(u.x));
            return receiver.right * (rho * std::cos(phi)) + receiver.up * (rho * std::sin(phi));
        }
        const double length = isCosine ? std::sqrt(double(u.x)) : std::cbrt(double(u.x));
        const double z = isCosine ? std::sqrt(1 - double(u.z)) : double(u.z), across = std::sqrt(1 - z * z);
        // Any frame about the normal will do: the azimuth is even.
        const glm::dvec3 n = receiver.shadingNormal;
        const glm::dvec3 aside = std::abs(n.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        const glm::dvec3 t = glm::normalize(glm::cross(n, aside)), b = glm::cross(n, t);
        return (t * (across * std::cos(phi)) + b * (across * std::sin(phi)) + n * z) * length;
    }

    const BlocksParams m_params;
    const double m_cosAngle;
};

}  // namespace

std::unique_ptr<AoIntegrand> makeIntegrand(const BlocksParams& params) {
    return std::make_unique<BlocksIntegrand>(params);
}

}  // namespace ombrage::blocks
