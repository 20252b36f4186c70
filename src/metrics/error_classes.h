// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include <ombrage/metrics.h>

namespace ombrage {

/// What the classes and the figures beside them are made of: everything that the truth alone decides.
struct ErrorZones {
    std::vector<float> toHardEdge_px;  ///< to the nearest true hard edge
    std::vector<bool> penumbra;        ///< in a soft light's true penumbra or within kPenumbraMargin_px of it
};
ErrorZones errorZones(const ShadowTruth& truth, const Receivers& receivers);

/// How far around a true penumbra a pixel still belongs to it: a shadow that is too wide errs just outside.
inline constexpr float kPenumbraMargin_px = 4;

/// An error below it is not counted, beside three standard errors of the truth.
double errorTolerance(const ShadowTruth& truth);

/// How far in pixels the picture of a hard edge may lie from the edge.
double aliasReach_px(const TexelFootprint& footprint, const ShadowTruth& truth, const Receivers& receivers,
                     std::size_t pixel);

/// The class of each pixel; None where it is masked or right.
std::vector<ErrorClass> classify(std::span<const float> visibility, const ShadowTruth& truth,
                                 const Receivers& receivers, const ErrorZones& zones, const ShadowQuestion& question);

/// What a plain hard shadow without an error of its own would show: of a soft light whether its centre is seen, 0 or 1;
/// of a hard one the truth.
std::vector<float> hardShadow(const ShadowTruth& truth);

}  // namespace ombrage
