// SPDX-License-Identifier: MIT
#include "techniques/ao/sao/own.h"

#include <algorithm>
#include <cmath>

#include "techniques/shared/obscurance.h"

namespace ombrage::sao {

namespace {

constexpr double kTwoPi = 6.28318530717958647693;

class SaoIntegrand final : public AoIntegrand {
public:
    explicit SaoIntegrand(const SaoParams& params) : m_params(params) {}

    double sample(const AoReceiver& receiver, const AoProbe& probe, const glm::vec4& u) const override {
        const double open = 1 - ownSurfaceShare(receiver);
        const double radius_m = m_params.radiusIn(receiver.sceneRadius_m, receiver.sceneDiagonal_m);
        // A point of the spiral, even in radius, and the surface seen there.
        const double rho_m = radius_m * double(u.x), phi = kTwoPi * double(u.y);
        const auto v =
            probe.seenTowards(receiver.right * (rho_m * std::cos(phi)) + receiver.up * (rho_m * std::sin(phi)));
        if (!v) return open;
        const double fall = std::max(0.0, 1 - glm::dot(*v, *v) / (radius_m * radius_m));
        return open -
               5 * double(m_params.intensity) * radius_m * fall * fall * fall *
                   obscuranceFrom(receiver, *v, double(m_params.bias) * radius_m, double(m_params.epsilon) * radius_m);
    }

private:
    const SaoParams m_params;
};

}  // namespace

std::unique_ptr<AoIntegrand> makeIntegrand(const SaoParams& params) {
    return std::make_unique<SaoIntegrand>(params);
}

}  // namespace ombrage::sao
