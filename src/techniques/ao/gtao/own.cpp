// SPDX-License-Identifier: MIT
#include "techniques/ao/gtao/own.h"

#include <algorithm>
#include <cmath>

namespace ombrage::gtao {

namespace {

constexpr double kPi = 3.14159265358979323846;

class GtaoIntegrand final : public AoIntegrand {
public:
    explicit GtaoIntegrand(const GtaoParams& params) : m_params(params) {}

    double sample(const AoReceiver& receiver, const AoProbe& probe, const glm::vec4& u) const override {
        const double radius_m = m_params.radiusIn(receiver.sceneRadius_m, receiver.sceneDiagonal_m);
        const AoSlice slice(receiver, double(u.x));
        if (!slice.isOpen()) return 1 - slice.share * aoWholeArc(slice.n_rad);

        // One of the slice's two sides stands for both.
        const int side = u.y < 0.5f ? 1 : -1;
        const double open_rad = side > 0 ? slice.high_rad : -slice.low_rad;
        const double lowest = std::cos(std::clamp(open_rad, 0.0, kPi));
        const double fade_m = std::max(double(m_params.falloff), 1e-4) * radius_m;
        // The cosine to the way to the eye of what is met, `lowest` where that is no occluder.
        const auto look = [&](double share) {
            const double aside_m = side * radius_m * std::pow(share, double(m_params.power));
            const auto found = probe.seenTowards(slice.along * aside_m);
            if (!found) return lowest;
            const double distance_m = glm::length(*found);
            if (distance_m <= 0 || glm::dot(*found, receiver.normal) <= 1e-4 * distance_m) return lowest;
            const double weight = std::clamp((radius_m - distance_m) / fade_m, 0.0, 1.0);
            return std::max(lowest, lowest + weight * (glm::dot(*found, receiver.toEye) / distance_m - lowest));
        };
        const double edge_rad = slice.n_rad + side * kPi / 2;
        const auto lost = [&](const AoMarch<double>& cosines) {
            const double decay = 1 - std::pow(1 - double(m_params.thickness), 1.0 / cosines.count);
            double horizon = lowest;
            for (int i = 0; i < cosines.count; ++i)
                horizon = cosines[i] >= horizon ? cosines[i] : horizon + decay * (cosines[i] - horizon);
            const double end_rad = slice.end(side, std::acos(std::clamp(horizon, -1.0, 1.0)));
            return side * (aoArc(slice.n_rad, edge_rad) - aoArc(slice.n_rad, end_rad));
        };
        return 1 - 2 * slice.share * endlessMarch(look, lost, double(u.z), double(u.w));
    }

private:
    const GtaoParams m_params;
};

}  // namespace

std::unique_ptr<AoIntegrand> makeIntegrand(const GtaoParams& params) {
    return std::make_unique<GtaoIntegrand>(params);
}

}  // namespace ombrage::gtao
