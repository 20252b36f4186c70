// SPDX-License-Identifier: MIT
#pragma once

#include "gl/objects.h"

namespace ombrage {

/// Copies level 0, all layers, between 2D textures or arrays of one size and format.
void copyTexture(const gl::Texture& input, const gl::Texture& output);

}  // namespace ombrage
