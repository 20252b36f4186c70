// SPDX-License-Identifier: MIT
#pragma once

#include "gl/objects.h"

namespace ombrage {

/// Copies level 0 between textures of one size and format.
void copyTexture(const gl::Texture& input, const gl::Texture& output);

}  // namespace ombrage
