// SPDX-License-Identifier: MIT
#include "techniques/ao/alchemy/own.h"

#include <algorithm>
#include <cmath>

#include "techniques/shared/obscurance.h"

namespace ombrage::alchemy {

namespace {

constexpr double kTwoPi = 6.28318530717958647693;

class AlchemyIntegrand final : public AoIntegrand {
public:
    explicit AlchemyIntegrand(const AlchemyParams& params) : m_params(params) {}

    double sample(const AoReceiver& receiver, const AoProbe& probe, const glm::vec4& u) const override {
        if (m_params.contrast == 1.0f) return term(receiver, probe, double(u.x), double(u.y));
        // A power of a mean is no mean: it is taken of one over 64 points, whose own error is far below the picture's.
        constexpr int kCount = 64;
        constexpr double kPlastic = 0.7548776662466927, kPlastic2 = 0.5698402909980532;
        double sum = 0;
        for (int i = 0; i < kCount; ++i) {
            const double x = double(u.x) + i * kPlastic, y = double(u.y) + i * kPlastic2;
            sum += term(receiver, probe, x - std::floor(x), y - std::floor(y));
        }
        return std::pow(std::max(0.0, sum / kCount), double(m_params.contrast));
    }

private:
    double term(const AoReceiver& receiver, const AoProbe& probe, double x, double y) const {
        const double open = 1 - ownSurfaceShare(receiver);
        const double radius_m = m_params.radiusIn(receiver.sceneRadius_m, receiver.sceneDiagonal_m);
        // A point of the disk, even in area, and the surface seen there.
        const double rho_m = radius_m * std::sqrt(x), phi = kTwoPi * y;
        const auto v =
            probe.seenTowards(receiver.right * (rho_m * std::cos(phi)) + receiver.up * (rho_m * std::sin(phi)));
        if (!v) return open;
        return open - 2 * double(m_params.intensity) * radius_m *
                          obscuranceFrom(receiver, *v, 0, double(m_params.epsilon) * radius_m);
    }

    const AlchemyParams m_params;
};

}  // namespace

std::unique_ptr<AoIntegrand> makeIntegrand(const AlchemyParams& params) {
    return std::make_unique<AlchemyIntegrand>(params);
}

}  // namespace ombrage::alchemy
