// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include <ombrage/ao_integrand.h>

#include "techniques/shared/screen_ao.h"

namespace ombrage {

/// What the techniques have in common that march along slices; shared/ao_slices.glsl reads it.
struct AoSliceParams : ScreenAoParams {
    int slices = 3;
    int steps = 6;
    float power = 2.0f;
    int mips = 0;
};

/// Their declarations between those of the technique and those of ScreenAoParams, with `defaults` as defaults.
ParamTable aoSliceTable(std::vector<ParamField> own, const AoSliceParams& defaults = {});

/// One slice about the way to the eye, as in shared/ao_slices.glsl, for the integrands.
struct AoSlice {
    glm::dvec3 along{0};
    double n_rad = 0, share = 0, low_rad = 0, high_rad = 0;

    /// @param turn [0,1) of half a turn
    AoSlice(const AoReceiver& receiver, double turn);

    /// Whether anything is above both planes.
    bool isOpen() const { return low_rad < high_rad; }
    /// The end of what is seen on one side of the way to the eye (+1 or -1) under a horizon at an angle to that way.
    double end(int side, double horizon_rad) const;
};

/// The integral of cos(t - n) |sin t| from 0 to h, negative for h < 0 (Jimenez et al. 2016, eq. 7).
double aoArc(double n_rad, double h_rad);
/// The same from n - 90 to n + 90 degrees.
double aoWholeArc(double n_rad);

/// Every `stride`-th of what a march met, from the receiver outwards.
template <typename Met>
struct AoMarch {
    const Met* first;
    int stride, count;
    const Met& operator[](int i) const { return first[i * stride]; }
};

/// The mean over u and v, even in [0,1), is fold() over a march of 256 steps, at a fourteenth of its cost: the march is
/// one of 8, 16, ... 256 steps, drawn with probability, of which each coarser one is a part; fold() of 4 steps takes
/// the drawn difference between two of them, by its probability (Rhee and Glynn 2015).
/// @param look Met(double), what is met at a share of the way
/// @param fold double(AoMarch<Met>)
template <typename Look, typename Fold>
double endlessMarch(const Look& look, const Fold& fold, double u, double v) {
    using Met = decltype(look(0.0));
    constexpr int kCoarsest = 4, kDoublings = 6;
    constexpr double kRatio = 0.4;  // cost doubles and the differences' variance falls to a quarter: about 2^-1.5
    double chance = 1 - kRatio, below = chance;
    int doublings = 1;
    for (; doublings < kDoublings && u >= below; ++doublings) {
        chance = doublings + 1 < kDoublings ? chance * kRatio : 1 - below;
        below += chance;
    }

    std::array<Met, kCoarsest << kDoublings> met;
    const int count = kCoarsest << doublings;
    const auto fraction = [](double x) { return x - std::floor(x); };
    for (int i = 0; i < count; ++i)
        met[std::size_t(i)] = look((i + fraction(v * double(1 << doublings))) / double(count));
    // Where the coarser grid of the same v lies in this one.
    const auto at = [&](int coarser) {
        const int stride = 1 << (doublings - coarser);
        const int first = int(fraction(v * double(1 << coarser)) * double(stride));
        return fold(AoMarch<Met>{met.data() + first, stride, kCoarsest << coarser});
    };
    return at(0) + (at(doublings) - at(doublings - 1)) / chance;
}

}  // namespace ombrage
