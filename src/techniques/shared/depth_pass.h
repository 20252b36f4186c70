// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "render/frame_context.h"
#include "techniques/shared/light_views.h"

namespace ombrage {

/// Draws the depth of every caster of a light into a map, opaque ones from the position stream alone. Counts into the
/// open pass. Six views are one layered pass.
/// @param map   2D array of as many layers as there are views, a depth format
/// @param cull  GL_NONE, GL_FRONT or GL_BACK, seen from the light
void drawLightDepth(FrameContext& frame, const LightFrame& light, const LightViews& views, const gl::Texture& map,
                    GLenum cull);

/// The same of those instances for which `takes` is true. @param keep what the map holds: draws onto it
void drawLightDepthOf(const std::vector<bool>& takes, bool keep, FrameContext& frame, const LightFrame& light,
                      const LightViews& views, const gl::Texture& map, GLenum cull);

}  // namespace ombrage
