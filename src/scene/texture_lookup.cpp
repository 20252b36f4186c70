// SPDX-License-Identifier: MIT
#include "scene/texture_lookup.h"

#include <cmath>

#include <ombrage/image.h>

namespace ombrage {

glm::vec3 textureColor(const Texture& texture, glm::vec2 uv) {
    if (texture.width <= 0 || texture.height <= 0 || !std::isfinite(uv.x) || !std::isfinite(uv.y)) return glm::vec3(1);
    const glm::vec2 position = (uv - glm::floor(uv)) * glm::vec2(texture.width, texture.height) - 0.5f;
    const glm::ivec2 corner(glm::floor(position));
    const glm::vec2 f = position - glm::vec2(corner);
    const auto texel = [&](int dx, int dy) {
        const int x = (corner.x + dx + texture.width) % texture.width;
        const int y = (corner.y + dy + texture.height) % texture.height;
        const std::uint8_t* p = &texture.rgba[(std::size_t(y) * std::size_t(texture.width) + std::size_t(x)) * 4];
        glm::vec3 c(p[0], p[1], p[2]);
        c /= 255.0f;
        return texture.srgb ? glm::vec3(linearFromSrgb(c.r), linearFromSrgb(c.g), linearFromSrgb(c.b)) : c;
    };
    return glm::mix(glm::mix(texel(0, 0), texel(1, 0), f.x), glm::mix(texel(0, 1), texel(1, 1), f.x), f.y);
}

}  // namespace ombrage
