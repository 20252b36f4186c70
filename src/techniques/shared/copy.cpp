// SPDX-License-Identifier: MIT
#include "techniques/shared/copy.h"

namespace ombrage {

void copyTexture(const gl::Texture& input, const gl::Texture& output) {
    const GLenum kind = input.desc().kind == gl::TextureKind::Array2D ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D;
    glCopyImageSubData(input.id(), kind, 0, 0, 0, 0, output.id(), kind, 0, 0, 0, 0, input.width(), input.height(),
                       input.desc().layers);
}

}  // namespace ombrage
