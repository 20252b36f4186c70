// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>
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

/// The scene in grey, to draw volumes into, and how: translucent, what is before the surfaces.
gl::Texture volumeBackdrop(FrameContext& frame);
gl::DrawState volumeOverlay();

/// Fragments of what is drawn so: front faces reddish and back faces bluish, brighter with OUTLINE, for wires; or
/// one colour with EDGE, LIGHT_CAP and DARK_CAP.
inline constexpr const char* kVolumeTintPath = "shared/volume_view.frag";

/// Exposes empty pictures in the place of those that a hard light has nothing to show in.
void showNothing(FrameContext& frame, std::initializer_list<const char*> names);

}  // namespace ombrage
