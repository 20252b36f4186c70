// SPDX-License-Identifier: MIT
#include "reference/surface_color.h"

#include "scene/texture_lookup.h"

namespace ombrage {

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
