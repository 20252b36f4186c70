// SPDX-License-Identifier: MIT
#include "techniques/ao/vbao/own.h"

#include <algorithm>
#include <bitset>
#include <cmath>

namespace ombrage::vbao {

namespace {

constexpr double kPi = 3.14159265358979323846;

/// What one point of a side covers, from 0 at the way to the eye to 1 at the end of the hemisphere of n_s.
struct Cover {
    double from = 0, to = 0;
};

class VbaoIntegrand final : public AoIntegrand {
public:
    explicit VbaoIntegrand(const VbaoParams& params) : m_params(params) {}

    double sample(const AoReceiver& receiver, const AoProbe& probe, const glm::vec4& u) const override {
        const double radius_m = m_params.radiusIn(receiver.sceneRadius_m, receiver.sceneDiagonal_m);
        const AoSlice slice(receiver, double(u.x));
        const bool isUniform = m_params.sectors == Sectors::Uniform;
        const double n_rad = slice.n_rad, weight = isUniform ? 1 : slice.share * aoWholeArc(n_rad);
        if (!slice.isOpen()) return 1 - weight;

        // One of the slice's two sides stands for both. Its measure of an angle from the way to the eye, in shares of
        // the hemisphere of n_s: even in what the slice sees of it, or in the angle.
        const int side = u.y < 0.5f ? 1 : -1;
        const auto until = [&](double angle_rad) {
            const double t = std::clamp(side * angle_rad, n_rad - kPi / 2, n_rad + kPi / 2);
            return isUniform ? side * t / kPi : side * slice.share * aoArc(n_rad, t);
        };
        const double nearest = until(0);
        const auto measure = [&](double angle_rad) { return until(std::max(angle_rad, 0.0)) - nearest; };
        const double start = measure(side > 0 ? slice.low_rad : -slice.high_rad);
        const double open = measure(side > 0 ? slice.high_rad : -slice.low_rad), whole = measure(kPi);

        const auto look = [&](double share) {
            const auto found =
                probe.seenTowards(slice.along * (side * radius_m * std::pow(share, double(m_params.power))));
            if (!found) return Cover{};
            const double distance_m = glm::length(*found);
            if (distance_m <= 0 || distance_m >= radius_m) return Cover{};
            if (glm::dot(*found, receiver.normal) <= 1e-4 * distance_m) return Cover{};
            const glm::dvec3 back = *found - receiver.toEye * double(m_params.thickness_m);
            const auto angle = [&](const glm::dvec3& v) {
                return std::acos(std::clamp(glm::dot(v, receiver.toEye) / glm::length(v), -1.0, 1.0));
            };
            return Cover{measure(angle(*found)), measure(angle(back))};
        };
        const auto lost = [&](const AoMarch<Cover>& covers) {
            constexpr int kSectors = 256;
            std::bitset<kSectors> isCovered;
            const double perSector = (open - start) / kSectors;
            if (!(perSector > 0)) return whole;
            for (int i = 0; i < covers.count; ++i) {
                const auto at = [&](double m) {
                    return std::clamp((m - start) / perSector + 0.5, 0.0, double(kSectors));
                };
                for (int k = int(at(covers[i].from)); k < int(at(covers[i].to)); ++k) isCovered.set(std::size_t(k));
            }
            return whole - open + start + double(isCovered.count()) * perSector;
        };
        return 1 - 2 * endlessMarch(look, lost, double(u.z), double(u.w));
    }

private:
    const VbaoParams m_params;
};

}  // namespace

std::unique_ptr<AoIntegrand> makeIntegrand(const VbaoParams& params) {
    return std::make_unique<VbaoIntegrand>(params);
}

}  // namespace ombrage::vbao
