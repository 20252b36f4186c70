// SPDX-License-Identifier: MIT
#include "techniques/ao/starcraft2/own.h"

#include <cmath>

#include "techniques/shared/ao_points.h"

namespace ombrage::starcraft2 {

namespace {

class Starcraft2Integrand final : public AoIntegrand {
public:
    explicit Starcraft2Integrand(const Starcraft2Params& params) : m_params(params) {}

    double sample(const AoReceiver& receiver, const AoProbe& probe, const glm::vec4& u) const override {
        const double radius_m = m_params.radiusIn(receiver.sceneRadius_m, receiver.sceneDiagonal_m);
        glm::dvec3 point = ballPoint(double(u.x), double(u.y), double(u.z)) * radius_m;
        if (glm::dot(point, receiver.shadingNormal) < 0) point = -point;
        const auto found = probe.seenTowards(point);
        if (!found) return 1;
        return 1 - double(m_params.intensity) * occlusion(depthBetween(receiver, *found, point) / radius_m);
    }

private:
    double occlusion(double before) const {
        const double full = double(m_params.full), none = double(m_params.none);
        if (before <= 0 || before >= none) return 0;
        return before <= full ? 1 : std::pow((none - before) / (none - full), double(m_params.power));
    }

    const Starcraft2Params m_params;
};

}  // namespace

std::unique_ptr<AoIntegrand> makeIntegrand(const Starcraft2Params& params) {
    return std::make_unique<Starcraft2Integrand>(params);
}

}  // namespace ombrage::starcraft2
