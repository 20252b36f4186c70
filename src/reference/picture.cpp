// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "reference/parallel_rows.h"
#include "reference/reference_impl.h"

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

Image Reference::picture(const Receivers& receivers, const Camera& camera, const ReferenceOptions& options) const {
    checkReceivers(receivers);
    const Scene& scene = m_impl->scene;
    const FlatScene& flat = m_impl->flat;
    const std::size_t count = receivers.triangle.size();

    // Each light and the occlusion is one stage of the progress.
    const double stages = double(scene.lights.size()) + 1;
    double stage = 0;
    ReferenceOptions part = options;
    if (options.progress) part.progress = [&](double share) { return options.progress((stage + share) / stages); };

    // Radiance of the surroundings, occluded; without a radius nothing is.
    std::vector<glm::vec3> arriving(count, glm::vec3(scene.ambient));
    if (scene.aoRadius_m > 0) {
        const AoTruth sky = ao(receivers, camera, part);
        for (std::size_t i = 0; i < count; ++i) arriving[i] *= sky.visibility[i];
    }

    // Direct light: what a Lambert surface sends back is irradiance / pi.
    for (std::size_t l = 0; l < scene.lights.size(); ++l) {
        stage += 1;
        const Light& light = scene.lights[l];
        const float luminance = 0.2126f * light.color.r + 0.7152f * light.color.g + 0.0722f * light.color.b;
        if (!(luminance > 0)) continue;
        const ShadowTruth truth = shadow(receivers, camera, int(l), part);
        for (std::size_t i = 0; i < count; ++i)
            arriving[i] += light.color * (truth.irradiance[i] * truth.irradianceShare[i] / (luminance * 3.14159265f));
    }

    Image image = Image::rgb(receivers.width, receivers.height);
    for (std::size_t i = 0; i < count; ++i) {
        glm::vec3 radiance(scene.ambient);
        if (receivers.triangle[i] != kNoHit) {
            const glm::uvec3 t = flat.triangles[receivers.triangle[i]];
            const glm::vec2 b = receivers.barycentric[i];
            const glm::vec2 uv = (1 - b.x - b.y) * flat.uvs[t.x] + b.x * flat.uvs[t.y] + b.y * flat.uvs[t.z];
            const Material& material = scene.materials[std::size_t(flat.instances[receivers.instance[i]].material)];
            const auto sampled = [&](int texture) {
                return texture < 0 ? glm::vec3(1) : textureColor(scene.textures[std::size_t(texture)], uv);
            };
            glm::vec3 color(1.0f);
            if (!flat.colors.empty())
                color = (1 - b.x - b.y) * flat.colors[t.x] + b.x * flat.colors[t.y] + b.y * flat.colors[t.z];
            radiance = material.baseColor * color * sampled(material.baseColorTexture) * arriving[i] +
                       material.emissive * sampled(material.emissiveTexture);
        }
        for (int c = 0; c < 3; ++c) image.plane(c)[i] = radiance[c];
    }
    return image;
}

}  // namespace ombrage
