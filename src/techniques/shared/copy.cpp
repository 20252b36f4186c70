// SPDX-License-Identifier: MIT
#include "techniques/shared/copy.h"

namespace ombrage {

void copyTexture(const gl::Texture& input, const gl::Texture& output) {
    glCopyImageSubData(input.id(), GL_TEXTURE_2D, 0, 0, 0, 0, output.id(), GL_TEXTURE_2D, 0, 0, 0, 0, input.width(),
                       input.height(), 1);
}

}  // namespace ombrage
