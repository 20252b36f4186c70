// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include <ombrage/scene.h>

namespace ombrage {

/// What a texture gives at a place: bilinear, repeated, of its finest level, in linear light. 1 where the place is no number or the
/// texture is empty.
glm::vec3 textureColor(const Texture& texture, glm::vec2 uv);

}  // namespace ombrage
