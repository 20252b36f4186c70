// SPDX-License-Identifier: MIT
#include "techniques/shared/ao_slices.h"

#include <algorithm>
#include <cmath>

namespace ombrage {

namespace {

constexpr double kPi = 3.14159265358979323846;

}  // namespace

ParamTable aoSliceTable(std::vector<ParamField> own, const AoSliceParams& defaults) {
    using P = AoSliceParams;
    std::vector<ParamField> shared = {
        field(&P::slices, "slices")
            .range(1, 32)
            .tune(1, 8)
            .effect(ParamEffect::Define)
            .help("Planes about the way to the eye for each pixel. More cost time, fewer give noise."),
        field(&P::steps, "steps")
            .range(1, 64)
            .tune(2, 16)
            .effect(ParamEffect::Define)
            .help(
                "Depths read on each of a slice's two sides: more find what is thin and the true end of what is wide."),
        field(&P::power, "power")
            .range(0.5, 4)
            .tune(1, 3)
            .help("How steps spread over the radius: 1 evenly, higher denser towards the receiver."),
        field(&P::mips, "mips")
            .range(0, 8)
            .effect(ParamEffect::Define)
            .help("Coarser levels of the depths that far steps read: faster where the radius covers hundreds of "
                  "pixels and the memory is slow; 0 reads the depths as they are.")};
    for (ParamField& one : shared) one.info.defaultValue = one.get(&defaults);
    own.insert(own.end(), shared.begin(), shared.end());
    return screenAoTable(std::move(own), defaults);
}

AoSlice::AoSlice(const AoReceiver& receiver, double turn) {
    // Any frame about the way to the eye will do: slices are even.
    const glm::dvec3 e = receiver.toEye;
    const glm::dvec3 t = glm::normalize(glm::cross(receiver.up, e)), b = glm::cross(e, t);
    along = t * std::cos(kPi * turn) + b * std::sin(kPi * turn);
    const auto angle = [&](const glm::dvec3& n) { return std::atan2(glm::dot(n, along), glm::dot(n, e)); };
    n_rad = angle(receiver.shadingNormal);
    share = std::hypot(glm::dot(receiver.shadingNormal, along), glm::dot(receiver.shadingNormal, e));
    const double ng_rad = angle(receiver.normal);
    low_rad = std::max(n_rad, ng_rad) - kPi / 2;
    high_rad = std::min(n_rad, ng_rad) + kPi / 2;
}

double AoSlice::end(int side, double horizon_rad) const {
    if (side > 0) return std::min(std::max(horizon_rad, std::max(low_rad, 0.0)), high_rad);
    return std::max(std::min(-horizon_rad, std::min(high_rad, 0.0)), low_rad);
}

double aoArc(double n_rad, double h_rad) {
    const double arc = 0.25 * (std::cos(n_rad) + 2 * h_rad * std::sin(n_rad) - std::cos(2 * h_rad - n_rad));
    return h_rad < 0 ? -arc : arc;
}

double aoWholeArc(double n_rad) {
    return aoArc(n_rad, n_rad + kPi / 2) - aoArc(n_rad, n_rad - kPi / 2);
}

}  // namespace ombrage
