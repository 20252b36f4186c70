// SPDX-License-Identifier: MIT
#pragma once

#include "gl/objects.h"
#include "render/frame_context.h"

namespace ombrage {

/// The part of the picture that a light can reach, from its range. Without one: everything.
struct LightRegion {
    bool empty = false;
    std::optional<gl::DrawState::Rect> scissor;
    std::optional<glm::vec2> depthBounds;  ///< of the stored, reversed depth

    LightRegion(const CameraView& view, const LightFrame& light);
};

}  // namespace ombrage
