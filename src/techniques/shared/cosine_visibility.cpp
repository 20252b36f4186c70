// SPDX-License-Identifier: MIT
#include "techniques/shared/cosine_visibility.h"

#include <cmath>

namespace ombrage {

namespace {

class CosineVisibility final : public AoIntegrand {
public:
    explicit CosineVisibility(double radius_m) : m_radius_m(radius_m) {}

    double sample(const AoReceiver& receiver, const AoProbe& probe, const glm::vec4& u) const override {
        // A point of the unit disk lifted to the sphere, in any frame about the normal.
        const glm::dvec3 n = receiver.shadingNormal;
        const glm::dvec3 aside = std::abs(n.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        const glm::dvec3 t = glm::normalize(glm::cross(n, aside)), b = glm::cross(n, t);
        const double phi = 6.28318530717958647693 * double(u.y), r = std::sqrt(double(u.x));
        const glm::dvec3 d = (t * std::cos(phi) + b * std::sin(phi)) * r + n * std::sqrt(1 - double(u.x));
        if (glm::dot(d, receiver.normal) <= 0) return 0;
        return probe.distanceTo(d, m_radius_m > 0 ? m_radius_m : receiver.sceneRadius_m) ? 0 : 1;
    }

private:
    const double m_radius_m;
};

}  // namespace

std::unique_ptr<AoIntegrand> makeCosineVisibility(double radius_m) {
    return std::make_unique<CosineVisibility>(radius_m);
}

}  // namespace ombrage
