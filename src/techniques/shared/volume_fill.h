// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "techniques/shared/shadow_volume.h"

namespace ombrage {

class VolumeCounter;

/// Fragments of volumes, which is what the stencil has to do.
struct VolumeFill {
    double all = 0;      ///< of everything that z-fail draws
    double counted = 0;  ///< of those, at the pixels where the mask is not 0; all of them without a mask
};

/// An R32F image of the picture's size, all 0, and the sum of one.
gl::Texture emptyFill(const FrameContext& frame);
double sumOf(const gl::Texture& fill);

/// How often everything that z-fail draws covers each pixel: R32F, of the picture's size.
gl::Texture drawFill(FrameContext& frame, const LightFrame& light, const ShadowVolumeOptions& options);

/// The same of the chosen instances' volumes as they are.
gl::Texture drawFill(FrameContext& frame, const LightFrame& light, const ShadowVolumes& volumes,
                     const VolumeChoice& chosen);

/// Adds that up, and waits for it: only where FrameContext::countsSavings() says so. `mask` is a one-channel image of
/// the picture's size.
VolumeFill countFill(FrameContext& frame, const LightFrame& light, const ShadowVolumeOptions& options,
                     const gl::Texture* mask = nullptr);

/// Fragments that `count` makes its counter draw.
double fillOf(FrameContext& frame, const LightFrame& light, const ShadowVolumes& volumes, bool twoSided,
              const std::function<void(const VolumeCounter&)>& count);

/// Puts "fill of z-fail" and, of it, "fill saved" into the record.
void reportFill(FrameContext& frame, const VolumeFill& fill);

}  // namespace ombrage
