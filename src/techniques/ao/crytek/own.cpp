// SPDX-License-Identifier: MIT
#include "techniques/ao/crytek/own.h"

#include <algorithm>

#include "techniques/shared/ao_points.h"

namespace ombrage::crytek {

namespace {

class CrytekIntegrand final : public AoIntegrand {
public:
    explicit CrytekIntegrand(const CrytekParams& params) : m_params(params) {}

    double sample(const AoReceiver& receiver, const AoProbe& probe, const glm::vec4& u) const override {
        const double radius_m = m_params.radiusIn(receiver.sceneRadius_m, receiver.sceneDiagonal_m);
        const glm::dvec3 point = ballPoint(double(u.x), double(u.y), double(u.z)) * radius_m;
        // With its opposite: the same mean, and no noise on flat surfaces.
        const double open =
            0.5 * (openAt(receiver, probe, point, radius_m) + openAt(receiver, probe, -point, radius_m));
        return m_params.remap ? 2 * open : open;
    }

private:
    double openAt(const AoReceiver& receiver, const AoProbe& probe, const glm::dvec3& point, double radius_m) const {
        const auto found = probe.seenTowards(point);
        if (!found) return 1;
        const double open = depthBetween(receiver, *found, point) > 0 ? 0 : 1;
        // What stands far in front of the receiver counts as a flat surface would.
        const double reach_m = double(m_params.range) * radius_m;
        const double before_m = depthBetween(receiver, *found, glm::dvec3(0));
        if (before_m <= reach_m) return open;
        const double unknown = reach_m > 0 ? std::min(before_m / reach_m - 1, 1.0) : 1.0;
        return open + (0.5 - open) * unknown;
    }

    const CrytekParams m_params;
};

}  // namespace

std::unique_ptr<AoIntegrand> makeIntegrand(const CrytekParams& params) {
    return std::make_unique<CrytekIntegrand>(params);
}

}  // namespace ombrage::crytek
