// SPDX-License-Identifier: MIT
#include "reference/surface_color.h"

#include <cmath>

#include <ombrage/image.h>

namespace ombrage {
namespace {

/// Bilinear, repeated, in linear light.
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

}  // namespace

SurfaceColor surfaceColor(const Scene& scene, const FlatScene& flat, std::uint32_t triangle, glm::vec2 b) {
    const glm::uvec3 t = flat.triangles[triangle];
    const glm::vec2 uv = (1 - b.x - b.y) * flat.uvs[t.x] + b.x * flat.uvs[t.y] + b.y * flat.uvs[t.z];
    const FlatInstance& instance = flat.instances[flat.triangleInstance[triangle]];
    const Material& material = scene.materials[std::size_t(instance.material)];
    const auto sampled = [&](int texture) {
        return texture < 0 ? glm::vec3(1) : textureColor(scene.textures[std::size_t(texture)], uv);
    };
    glm::vec3 color(1.0f);
    if (!flat.colors.empty())
        color = (1 - b.x - b.y) * flat.colors[t.x] + b.x * flat.colors[t.y] + b.y * flat.colors[t.z];
    return {material.baseColor * color * sampled(material.baseColorTexture),
            material.emissive * sampled(material.emissiveTexture)};
}

}  // namespace ombrage
