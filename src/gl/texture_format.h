// SPDX-License-Identifier: MIT
#pragma once

#include <epoxy/gl.h>

namespace ombrage::gl {

/// Bytes of one texel of a sized internal format, 0 for a format that Ombrage does not know.
int texelSize(GLenum format);

bool hasDepth(GLenum format);
bool hasStencil(GLenum format);

/// Pixel store of tightly packed client memory: alignment 1, no row length or skips, no pixel buffers bound.
void setTightPixelStore();

}  // namespace ombrage::gl
