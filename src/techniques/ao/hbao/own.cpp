// SPDX-License-Identifier: MIT
#include "techniques/ao/hbao/own.h"

#include <algorithm>
#include <cmath>

namespace ombrage::hbao {

namespace {

constexpr double kHalfPi = 1.57079632679489661923;
constexpr int kSteps = 24;

/// Elevation of a plane over the one across the line of sight, in the direction `aside`.
double tangentAngle(const glm::dvec3& n, const glm::dvec3& aside, const glm::dvec3& toEye) {
    return std::atan2(-glm::dot(n, aside), std::max(glm::dot(n, toEye), 1e-6));
}

/// Unit vector towards the eye: a ray of sight through a point close above the receiver is parallel to the receiver's.
glm::dvec3 toEyeOf(const AoReceiver& receiver, const AoProbe& probe, double radius_m) {
    const glm::dvec3 back = glm::cross(receiver.right, receiver.up);
    const glm::dvec3 above = receiver.normal * (0.01 * radius_m);
    const auto seen = probe.seenTowards(above);
    if (!seen || glm::length(*seen - above) == 0) return back;
    const glm::dvec3 along = glm::normalize(*seen - above);
    return glm::dot(along, back) > 0 ? along : -along;
}

class HbaoIntegrand final : public AoIntegrand {
public:
    explicit HbaoIntegrand(const HbaoParams& params) : m_params(params) {}

    double sample(const AoReceiver& receiver, const AoProbe& probe, const glm::vec4& u) const override {
        const double radius_m = m_params.radiusIn(receiver.sceneRadius_m, receiver.sceneDiagonal_m);
        const glm::dvec3 toEye = toEyeOf(receiver, probe, radius_m);
        const glm::dvec3 x = glm::normalize(glm::cross(receiver.up, toEye)), y = glm::cross(toEye, x);
        const double theta = 4 * kHalfPi * double(u.x);
        const glm::dvec3 aside = x * std::cos(theta) + y * std::sin(theta);

        // What rises over the biased horizon, beside the own surface between the planes of n_s and n_g.
        const double start_rad =
            std::max(tangentAngle(receiver.shadingNormal, aside, toEye), tangentAngle(receiver.normal, aside, toEye));
        double occlusion = ownSurfaceShare(receiver);
        double horizon = std::sin(std::min(kHalfPi, start_rad + double(m_params.angleBias_rad)));
        for (int i = 0; i < kSteps; ++i) {
            const auto v = probe.seenTowards(aside * (radius_m * (i + double(u.y)) / kSteps));
            if (!v) continue;
            const double distance_m = glm::length(*v);
            if (distance_m <= 0 || distance_m >= radius_m) continue;
            const double rise = glm::dot(*v, toEye) / distance_m;
            if (rise <= horizon) continue;
            occlusion += (1 - distance_m * distance_m / (radius_m * radius_m)) * (rise - horizon);
            horizon = rise;
        }
        return 1 - occlusion;
    }

private:
    const HbaoParams m_params;
};

}  // namespace

std::unique_ptr<AoIntegrand> makeIntegrand(const HbaoParams& params) {
    return std::make_unique<HbaoIntegrand>(params);
}

}  // namespace ombrage::hbao
