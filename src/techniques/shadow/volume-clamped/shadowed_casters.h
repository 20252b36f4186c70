// SPDX-License-Identifier: MIT
#pragma once

#include "render/frame_context.h"
#include "techniques/shadow/volume-clamped/receiver_grid.h"
#include "techniques/shared/shadow_volume.h"

namespace ombrage {

/// The casters that lie wholly in the shadow of a single other one, so that they shade nothing that it does not. Never
/// one that does not; one in the joint shadow of several is not found.
VolumeChoice shadowedCasters(FrameContext& frame, const LightFrame& light, const ShadowVolumes& volumes,
                             const LightRays& rays);

}  // namespace ombrage
