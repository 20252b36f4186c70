// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <epoxy/gl.h>

namespace ombrage::gl {

/// Notes that an image is attached or bound, to be written or read by the draws that follow in this thread. An image
/// counts once until takeTraffic(), whatever is done to it.
void noteImage(GLuint texture, std::uint64_t bytes);

/// Bytes of the images noted since the last call: what it takes to move each of them once, a floor for a pass that
/// touches all of them. Textures with mip levels are never noted, as nobody knows how much of them is read.
std::uint64_t takeTraffic();

}  // namespace ombrage::gl
