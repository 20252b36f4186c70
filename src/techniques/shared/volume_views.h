// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <ombrage/technique.h>

#include "techniques/shared/shadow_volume.h"

namespace ombrage {

/// The pictures that every technique of volumes offers, for TechniqueTraits::passes.
std::vector<PassInfo> volumePasses();

/// Exposes those that somebody wants. The stencil plane holds the count.
void showVolumes(FrameContext& frame, const LightFrame& light, const ShadowVolumes& volumes,
                 const VolumeChoice& chosen);
void showVolumes(FrameContext& frame, const LightFrame& light, const ShadowVolumes& volumes);

}  // namespace ombrage
