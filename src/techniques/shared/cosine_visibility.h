// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <ombrage/ao_integrand.h>

#include "techniques/shared/ao_radius.h"

namespace ombrage {

/// Cosine-weighted visibility about the shading normal, V = 1/pi int vis(w) (n_s . w)+ dw over the hemisphere, where
/// what is nearer than a radius occludes fully and so does the receiver's own surface below its geometric horizon: the
/// truth T1 with a radius of one's own, T4 without any.
std::unique_ptr<AoIntegrand> makeCosineVisibility(const AoRadius& radius);
std::unique_ptr<AoIntegrand> makeUnboundedVisibility();

}  // namespace ombrage
