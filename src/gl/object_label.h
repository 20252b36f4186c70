// SPDX-License-Identifier: MIT
#pragma once

#include <cstring>

#include <epoxy/gl.h>

namespace ombrage::gl {

/// Names an object for debuggers. A null or empty label does nothing; one over 255 bytes (the shortest limit that a
/// driver may have) is cut there.
inline void labelObject(GLenum kind, GLuint id, const char* label) {
    if (label == nullptr || *label == '\0') return;
    glObjectLabel(kind, id, GLsizei(strnlen(label, 255)), label);
}

}  // namespace ombrage::gl
