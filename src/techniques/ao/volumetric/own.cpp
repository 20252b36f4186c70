// SPDX-License-Identifier: MIT
#include "techniques/ao/volumetric/own.h"

#include "techniques/shared/ao_points.h"

namespace ombrage::volumetric {

namespace {

/// All ways to sample have one integral.
class VolumetricIntegrand final : public AoIntegrand {
public:
    explicit VolumetricIntegrand(const VolumetricParams& params) : m_params(params) {}

    double sample(const AoReceiver& receiver, const AoProbe& probe, const glm::vec4& u) const override {
        const double radius_m = m_params.radiusIn(receiver.sceneRadius_m, receiver.sceneDiagonal_m);
        glm::dvec3 point = ballPoint(double(u.x), double(u.y), double(u.z)) * radius_m;
        if (m_params.clip && glm::dot(point, receiver.shadingNormal) < 0) point = -point;
        const double whole = m_params.clip ? 1 : 2;
        const auto found = probe.seenTowards(point);
        if (!found || depthBetween(receiver, *found, point) <= 0) return whole;
        // Hidden from the eye, but not by more than the surface's thickness behind it.
        const double thickness_m = double(m_params.thickness) * radius_m;
        return thickness_m > 0 && glm::length(*found - point) >= thickness_m ? whole : 0;
    }

private:
    const VolumetricParams m_params;
};

}  // namespace

std::unique_ptr<AoIntegrand> makeIntegrand(const VolumetricParams& params) {
    return std::make_unique<VolumetricIntegrand>(params);
}

}  // namespace ombrage::volumetric
