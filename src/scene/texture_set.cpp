// SPDX-License-Identifier: MIT
#include "scene/texture_set.h"

#include <algorithm>
#include <cmath>

#include <ombrage/error.h>
#include <tbb/parallel_for.h>

#include "scene/load_record.h"

namespace ombrage {

int TextureSet::add(const std::filesystem::path& file, bool srgb) {
    LoadRecord::content(file, true);
    return add(file.lexically_normal().string(), srgb, [file] { return readImage(file); });
}

int TextureSet::add(const std::string& key, bool srgb, std::function<Image()> decode) {
    const auto [found, isNew] = m_indices.try_emplace(key + (srgb ? " colour" : " data"), int(m_requests.size()));
    if (isNew) m_requests.push_back({key, srgb, std::move(decode)});
    return found->second;
}

std::vector<Texture> TextureSet::decode(std::vector<std::string>& warnings) const {
    std::vector<Texture> textures(m_requests.size());
    std::vector<std::string> problems(m_requests.size());
    tbb::parallel_for(std::size_t(0), m_requests.size(), [&](std::size_t i) {
        const Request& request = m_requests[i];
        try {
            textures[i] = toTexture(request.decode(), request.key, request.srgb);
        } catch (const Error& error) {
            problems[i] = "texture '" + request.key + "' is left out: " + error.what();
        }
    });
    for (const std::string& problem : problems)
        if (!problem.empty()) warnings.push_back(problem);
    return textures;
}

Texture toTexture(const Image& image, const std::string& name, bool srgb) {
    // Float pictures hold light; as colours they are encoded like the 8-bit ones.
    const Image encoded = srgb && image.colorSpace() == ColorSpace::Linear ? toSrgb(image) : Image();
    const Image& source = encoded.empty() ? image : encoded;
    Texture texture;
    texture.name = std::filesystem::path(name).filename().string();
    texture.width = source.width();
    texture.height = source.height();
    texture.srgb = srgb;
    texture.rgba.assign(source.pixelCount() * 4, 255);
    const int grey = source.planeCount() > 0 && source.findPlane("R") < 0 ? std::max(0, source.findPlane("Y")) : -1;
    const char* names[4] = {"R", "G", "B", "A"};
    for (int channel = 0; channel < 4; ++channel) {
        int index = source.findPlane(names[channel]);
        if (index < 0 && channel < 3) index = grey;
        if (index < 0) continue;
        const std::span<const float> plane = source.plane(index);
        for (std::size_t i = 0; i < plane.size(); ++i) {
            const float value = std::clamp(plane[i], 0.0f, 1.0f);  // float pictures saturate, as on a display
            texture.rgba[4 * i + std::size_t(channel)] = std::uint8_t(value * 255.0f + 0.5f);
        }
    }
    return texture;
}

bool hasHoles(const Texture& texture) {
    for (std::size_t i = 3; i < texture.rgba.size(); i += 4)
        if (texture.rgba[i] < 128) return true;
    return false;
}

bool looksLikeNormalMap(const Texture& texture) {
    std::size_t unitCount = 0;
    const std::size_t count = texture.rgba.size() / 4;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec3 n =
            glm::vec3(texture.rgba[4 * i], texture.rgba[4 * i + 1], texture.rgba[4 * i + 2]) / 127.5f - 1.0f;
        // Greys have three equal parts; a normal map's blue stands out.
        if (std::abs(glm::length(n) - 1.0f) < 0.15f && n.z > 0.3f && n.z - std::max(n.x, n.y) > 0.1f) ++unitCount;
    }
    return count > 0 && unitCount * 10 > count * 8;
}

Texture withOpacity(const Texture& color, const Texture& opacity) {
    Texture result = color;
    result.name = color.name + " with " + opacity.name;
    bool alphaVaries = false;
    for (std::size_t i = 3; i < opacity.rgba.size() && !alphaVaries; i += 4)
        alphaVaries = opacity.rgba[i] != opacity.rgba[3];
    for (int y = 0; y < result.height; ++y)
        for (int x = 0; x < result.width; ++x) {
            const auto sourceX = std::size_t(std::int64_t(x) * opacity.width / result.width);
            const auto sourceY = std::size_t(std::int64_t(y) * opacity.height / result.height);
            const std::size_t source = (sourceY * std::size_t(opacity.width) + sourceX) * 4;
            const std::size_t target = (std::size_t(y) * std::size_t(result.width) + std::size_t(x)) * 4;
            result.rgba[target + 3] = opacity.rgba[source + (alphaVaries ? 3 : 0)];
        }
    return result;
}

void compactTextures(std::vector<Texture>& textures, std::vector<Material>& materials) {
    std::vector<int> number(textures.size(), -1);
    std::vector<Texture> kept;
    for (Material& material : materials)
        for (int* index : {&material.baseColorTexture, &material.normalTexture, &material.heightTexture,
                           &material.metallicRoughnessTexture, &material.emissiveTexture}) {
            if (*index < 0) continue;
            const std::size_t old = std::size_t(*index);
            if (number[old] < 0 && !textures[old].rgba.empty()) {
                number[old] = int(kept.size());
                kept.push_back(std::move(textures[old]));
            }
            *index = number[old];
        }
    textures = std::move(kept);
}

}  // namespace ombrage
