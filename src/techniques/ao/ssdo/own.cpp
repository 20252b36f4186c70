// SPDX-License-Identifier: MIT
#include "techniques/ao/ssdo/own.h"

#include "techniques/shared/ao_points.h"

namespace ombrage::ssdo {

namespace {

class SsdoIntegrand final : public AoIntegrand {
public:
    explicit SsdoIntegrand(const SsdoParams& params) : m_params(params) {}

    double sample(const AoReceiver& receiver, const AoProbe& probe, const glm::vec4& u) const override {
        const double radius_m = m_params.radiusIn(receiver.sceneRadius_m, receiver.sceneDiagonal_m);
        const glm::dvec3 point =
            cosineDirection(receiver.shadingNormal, double(u.x), double(u.y)) * (double(u.z) * radius_m);
        const auto found = probe.seenTowards(point);
        return found && depthBetween(receiver, *found, point) > 0 ? 0 : 1;
    }

private:
    const SsdoParams m_params;
};

}  // namespace

std::unique_ptr<AoIntegrand> makeIntegrand(const SsdoParams& params) {
    return std::make_unique<SsdoIntegrand>(params);
}

}  // namespace ombrage::ssdo
