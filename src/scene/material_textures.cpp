// SPDX-License-Identifier: MIT
#include "scene/material_textures.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "scene/asset_path.h"

namespace ombrage {

namespace {
/// Drops an index whose texture could not be decoded.
void dropIfEmpty(int& index, const std::vector<Texture>& textures) {
    if (index >= 0 && textures[std::size_t(index)].rgba.empty()) index = -1;
}

void dropEmptyTextures(Material& material, const std::vector<Texture>& textures) {
    for (int* index : {&material.baseColorTexture, &material.normalTexture, &material.heightTexture,
                       &material.metallicRoughnessTexture, &material.emissiveTexture})
        dropIfEmpty(*index, textures);
}

/// Many files name a normal map where a height map belongs.
void moveNormalMap(Material& material, const std::vector<Texture>& textures, std::vector<std::string>& warnings) {
    if (material.heightTexture < 0 || !looksLikeNormalMap(textures[std::size_t(material.heightTexture)])) return;
    if (material.normalTexture < 0) material.normalTexture = material.heightTexture;
    material.heightTexture = -1;
    warnings.push_back("material '" + material.name + "': its bump map holds normals and is taken as a normal map");
}

/// Gives the material the opacity picture as the alpha of its colour texture.
void applyOpacityMap(Material& material, int opacityTexture, std::vector<Texture>& textures) {
    const Texture& opacity = textures[std::size_t(opacityTexture)];
    Texture white{"white", opacity.width, opacity.height, true, std::vector<std::uint8_t>(opacity.rgba.size(), 255)};
    const Texture& color = material.baseColorTexture >= 0 ? textures[std::size_t(material.baseColorTexture)] : white;
    Texture merged = withOpacity(color, opacity);
    material.baseColorTexture = int(textures.size());
    material.alphaMode = AlphaMode::Mask;
    textures.push_back(std::move(merged));
}
}  // namespace

MaterialTextures::MaterialTextures(std::filesystem::path folder, std::vector<std::string>& warnings)
    : m_folder(std::move(folder)), m_warnings(warnings) {}

int MaterialTextures::pick(const std::string& name, bool srgb, const std::filesystem::path& firstFolder) {
    if (name.empty()) return -1;
    std::optional<std::filesystem::path> file;
    if (!firstFolder.empty()) file = findAsset(firstFolder, name);
    if (!file) file = findAsset(m_folder, name);
    if (!file) file = findAsset(m_folder, percentDecoded(name));
    if (file) return m_set.add(*file, srgb);
    const std::string warning =
        "texture '" + name + "' " + whyNotFound(firstFolder.empty() ? m_folder : firstFolder, name);
    if (std::find(m_warnings.begin(), m_warnings.end(), warning) == m_warnings.end()) m_warnings.push_back(warning);
    return -1;
}

int MaterialTextures::add(const std::string& key, bool srgb, std::function<Image()> decode) {
    return m_set.add(key, srgb, std::move(decode));
}

void MaterialTextures::finish(ModelFile& model, const std::vector<int>& opacity) {
    model.textures = m_set.decode(m_warnings);
    for (std::size_t i = 0; i < model.materials.size(); ++i) {
        dropEmptyTextures(model.materials[i], model.textures);
        int mask = i < opacity.size() ? opacity[i] : -1;
        dropIfEmpty(mask, model.textures);
        if (mask >= 0) applyOpacityMap(model.materials[i], mask, model.textures);
        moveNormalMap(model.materials[i], model.textures, m_warnings);
    }
}

void guessAlphaMode(Material& material, const std::vector<Texture>& textures) {
    if (material.baseColorTexture >= 0 && hasHoles(textures[std::size_t(material.baseColorTexture)]))
        material.alphaMode = AlphaMode::Mask;
    else if (material.alpha < 1.0f)
        material.alphaMode = AlphaMode::Blend;
}

std::string percentDecoded(const std::string& text) {
    const auto digit = [](char c) {
        if (c >= '0' && c <= '9') return c - '0';
        if (c >= 'a' && c <= 'f') return c - 'a' + 10;
        return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
    };
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool code = text[i] == '%' && i + 2 < text.size() && digit(text[i + 1]) >= 0 && digit(text[i + 2]) >= 0;
        result += code ? char(digit(text[i + 1]) * 16 + digit(text[i + 2])) : text[i];
        if (code) i += 2;
    }
    return result;
}

}  // namespace ombrage
