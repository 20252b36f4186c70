// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <ombrage/reference.h>

namespace ombrage {

/// Pixels on both sides of a true hard edge: valid neighbours on one surface or on adjacent ones whose v* differ by
/// more than a half. Where the surface ends against one behind it there is a jump of depth and no shadow edge.
std::vector<bool> hardEdges(const ShadowTruth& truth, const Receivers& receivers);

/// Length of the same edges in pixels: every crossing between two pixels counts by the cosine between the step and the
/// edge's normal, told from the pixels around, so that a slanted edge is as long as a straight one.
double hardEdgeLength_px(const ShadowTruth& truth, const Receivers& receivers);

}  // namespace ombrage
