// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "render/frame_context.h"
#include "render/technique.h"
#include "techniques/shadow/planar/planar_params.h"
#include "techniques/shadow/planar/receiver_planes.h"

namespace ombrage::planar {

/// The casters of one plane, flattened, with a border around the picture.
struct CasterMask {
    /// RG16F with mipmaps, 0 where nothing covers it: 1, and 1 less the height of the lowest caster as a share of
    /// ActivePlane::highest_m.
    const gl::Texture* mask = nullptr;
    const gl::Texture* casterColor = nullptr;  ///< of the caster's surface, for textured shadows
    glm::vec2 zoom{1.0f};                      ///< the picture's share of it
};

/// Points of the unit disk on Vogel's spiral: xy even in area, zw denser towards the middle, for a search that must
/// find both wide and narrow half-shadows; the first zw is the centre.
std::vector<glm::vec4> blurKernel(int samples);

/// Spreads the mask by the light's size, or by the constant width, onto `seen`, where `state` lets it.
/// @param isColored `seen` has a second attachment for the light that passes, in colour
void blurMask(FrameContext& frame, Technique& technique, const Params& params, const LightFrame& light,
              const ActivePlane& plane, const CasterMask& casters, const gl::Framebuffer& seen, bool isColored,
              const gl::DrawState& state);

}  // namespace ombrage::planar
