// SPDX-License-Identifier: MIT
#include "techniques/shared/cosine_visibility.h"

#include <cmath>
#include <limits>
#include <optional>

namespace ombrage {

namespace {

class CosineVisibility final : public AoIntegrand {
public:
    explicit CosineVisibility(std::optional<AoRadius> radius) : m_radius(radius) {}

    double sample(const AoReceiver& receiver, const AoProbe& probe, const glm::vec4& u) const override {
        // A point of the unit disk lifted to the sphere, in any frame about the normal.
        const glm::dvec3 n = receiver.shadingNormal;
        const glm::dvec3 aside = std::abs(n.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        const glm::dvec3 t = glm::normalize(glm::cross(n, aside)), b = glm::cross(n, t);
        const double phi = 6.28318530717958647693 * double(u.y), r = std::sqrt(double(u.x));
        const glm::dvec3 d = (t * std::cos(phi) + b * std::sin(phi)) * r + n * std::sqrt(1 - double(u.x));
        if (glm::dot(d, receiver.normal) <= 0) return 0;
        const double radius_m = m_radius ? m_radius->radiusIn(receiver.sceneRadius_m, receiver.sceneDiagonal_m)
                                         : std::numeric_limits<double>::infinity();
        return probe.distanceTo(d, radius_m) ? 0 : 1;
    }

private:
    const std::optional<AoRadius> m_radius;  ///< nothing: unbounded
};

}  // namespace

std::unique_ptr<AoIntegrand> makeCosineVisibility(const AoRadius& radius) {
    return std::make_unique<CosineVisibility>(radius);
}

std::unique_ptr<AoIntegrand> makeUnboundedVisibility() {
    return std::make_unique<CosineVisibility>(std::nullopt);
}

}  // namespace ombrage
