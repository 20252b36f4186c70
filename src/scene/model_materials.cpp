// SPDX-License-Identifier: MIT
#include "scene/model_materials.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <assimp/scene.h>

#include "core/strings.h"
#include "scene/asset_path.h"
#include "scene/texture_set.h"

namespace ombrage {

namespace {
/// Picks textures for materials: finds files, remembers what is missing.
class TexturePicker {
public:
    TexturePicker(TextureSet& set, const std::filesystem::path& folder, std::vector<std::string>& warnings)
        : m_set(set), m_folder(folder), m_warnings(warnings) {}

    /// Index of the texture of a file, -1 (and one warning per name) when there is none.
    int pick(const std::string& name, bool srgb) {
        if (name.empty()) return -1;
        std::optional<std::filesystem::path> file = findAsset(m_folder, name);
        if (!file) file = findAsset(m_folder, percentDecoded(name));
        if (file) return m_set.add(*file, srgb);
        const std::string warning = "texture '" + name + "' is missing";
        if (std::find(m_warnings.begin(), m_warnings.end(), warning) == m_warnings.end()) m_warnings.push_back(warning);
        return -1;
    }

private:
    static std::string percentDecoded(const std::string& text) {
        const auto digit = [](char c) {
            if (c >= '0' && c <= '9') return c - '0';
            if (c >= 'a' && c <= 'f') return c - 'a' + 10;
            return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
        };
        std::string result;
        for (std::size_t i = 0; i < text.size(); ++i) {
            const bool code =
                text[i] == '%' && i + 2 < text.size() && digit(text[i + 1]) >= 0 && digit(text[i + 2]) >= 0;
            result += code ? char(digit(text[i + 1]) * 16 + digit(text[i + 2])) : text[i];
            if (code) i += 2;
        }
        return result;
    }

    TextureSet& m_set;
    const std::filesystem::path& m_folder;
    std::vector<std::string>& m_warnings;
};

/// Drops an index whose texture could not be decoded.
void dropIfEmpty(int& index, const std::vector<Texture>& textures) {
    if (index >= 0 && textures[std::size_t(index)].rgba.empty()) index = -1;
}

void dropEmptyTextures(Material& material, const std::vector<Texture>& textures) {
    for (int* index : {&material.baseColorTexture, &material.normalTexture, &material.heightTexture,
                       &material.metallicRoughnessTexture, &material.emissiveTexture})
        dropIfEmpty(*index, textures);
}

/// Files without alpha modes: holes in the colour texture cut, a factor below 1 blends.
void guessAlphaMode(Material& material, const std::vector<Texture>& textures) {
    if (material.baseColorTexture >= 0 && hasHoles(textures[std::size_t(material.baseColorTexture)]))
        material.alphaMode = AlphaMode::Mask;
    else if (material.alpha < 1.0f)
        material.alphaMode = AlphaMode::Blend;
}

/// Many files name a normal map where a height map belongs.
void moveNormalMap(Material& material, const std::vector<Texture>& textures, std::vector<std::string>& warnings) {
    if (material.heightTexture < 0 || !looksLikeNormalMap(textures[std::size_t(material.heightTexture)])) return;
    if (material.normalTexture < 0) material.normalTexture = material.heightTexture;
    material.heightTexture = -1;
    warnings.push_back("material '" + material.name + "': its bump map holds normals and is taken as a normal map");
}

float roughnessOf(float shininess) {
    return std::sqrt(2.0f / (std::max(shininess, 0.0f) + 2.0f));
}

Material fromMtl(const std::string& name, const MtlMaterial& mtl, TexturePicker& picker) {
    Material material;
    material.name = name;
    material.baseColor = mtl.diffuse.value_or(glm::vec3(mtl.diffuseMap.empty() ? 0.8f : 1.0f));
    material.specular = mtl.specular.value_or(glm::vec3(0.0f));
    material.emissive = mtl.emissive.value_or(glm::vec3(mtl.emissiveMap.empty() ? 0.0f : 1.0f));
    if (!mtl.emissiveMap.empty() && material.emissive == glm::vec3(0.0f)) material.emissive = glm::vec3(1.0f);
    // An exponent below 1 is no highlight at all; Blinn and Phong then agree on a broad one.
    if (mtl.shininess) material.shininess = std::max(1.0f, *mtl.shininess);
    if (mtl.roughness)
        material.roughness = *mtl.roughness;
    else if (mtl.shininess && material.specular != glm::vec3(0.0f))
        material.roughness = roughnessOf(*mtl.shininess);
    material.metallic = mtl.metallic.value_or(0.0f);
    material.alpha = mtl.opacity.value_or(1.0f);
    material.baseColorTexture = picker.pick(mtl.diffuseMap, true);
    material.emissiveTexture = picker.pick(mtl.emissiveMap, true);
    material.normalTexture = picker.pick(mtl.normalMap, false);
    material.heightTexture = picker.pick(mtl.heightMap, false);
    material.heightScale_uv *= mtl.bumpMultiplier;
    return material;
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

void readObjMaterials(const std::vector<std::string>& names, const MtlLibrary& library,
                      const std::filesystem::path& folder, std::vector<Material>& materials,
                      std::vector<Texture>& textures, std::vector<std::string>& warnings) {
    TextureSet set;
    TexturePicker picker(set, folder, warnings);
    std::vector<int> opacityTextures;
    for (const std::string& name : names) {
        const auto found = library.find(name);
        const MtlMaterial mtl = found == library.end() ? MtlMaterial{} : found->second;
        if (found == library.end() && !library.empty() && name != "DefaultMaterial")
            warnings.push_back("material '" + name + "' is not in the material file; a grey one stands in");
        materials.push_back(fromMtl(name, mtl, picker));
        opacityTextures.push_back(picker.pick(mtl.opacityMap, false));
    }
    textures = set.decode(warnings);
    for (std::size_t i = 0; i < materials.size(); ++i) {
        dropEmptyTextures(materials[i], textures);
        dropIfEmpty(opacityTextures[i], textures);
        if (opacityTextures[i] >= 0)
            applyOpacityMap(materials[i], opacityTextures[i], textures);
        else
            guessAlphaMode(materials[i], textures);
        moveNormalMap(materials[i], textures, warnings);
    }
    compactTextures(textures, materials);
}

namespace {
std::string textOf(const aiString& text) {
    return std::string(text.data, text.length);
}

/// Pixels of a texture inside the file: a PNG or JPEG, or bare texels.
Image decodeEmbedded(const aiTexture& texture, const std::string& name) {
    if (texture.mHeight == 0)
        return decodeImage({reinterpret_cast<const unsigned char*>(texture.pcData), texture.mWidth}, name);
    Image image(int(texture.mWidth), int(texture.mHeight), {"R", "G", "B", "A"}, ColorSpace::Srgb);
    for (std::size_t i = 0; i < image.pixelCount(); ++i) {
        const aiTexel& texel = texture.pcData[i];
        const unsigned char values[4] = {texel.r, texel.g, texel.b, texel.a};
        for (int channel = 0; channel < 4; ++channel) image.plane(channel)[i] = float(values[channel]) / 255.0f;
    }
    return image;
}

class SceneMaterialReader {
public:
    SceneMaterialReader(const aiScene& source, TextureSet& set, TexturePicker& picker)
        : m_source(source), m_set(set), m_picker(picker) {}

    Material read(const aiMaterial& in) {
        Material out;
        aiString name;
        if (in.Get(AI_MATKEY_NAME, name) == AI_SUCCESS) out.name = textOf(name);
        readFactors(in, out);
        out.baseColorTexture = texture(in, aiTextureType_BASE_COLOR, true);
        if (out.baseColorTexture < 0) out.baseColorTexture = texture(in, aiTextureType_DIFFUSE, true);
        out.emissiveTexture = texture(in, aiTextureType_EMISSIVE, true);
        out.normalTexture = texture(in, aiTextureType_NORMALS, false);
        out.heightTexture = texture(in, aiTextureType_HEIGHT, false);
        // The library hands glTF's metallic-roughness texture on as "unknown".
        out.metallicRoughnessTexture = texture(in, aiTextureType_UNKNOWN, false);
        return out;
    }

private:
    static void readFactors(const aiMaterial& in, Material& out) {
        aiColor4D color;
        float value = 0;
        if (in.Get(AI_MATKEY_BASE_COLOR, color) == AI_SUCCESS) {
            out.alpha = color.a;
            out.baseColor = glm::vec3(color.r, color.g, color.b);
        } else {
            if (in.Get(AI_MATKEY_COLOR_DIFFUSE, color) == AI_SUCCESS)
                out.baseColor = glm::vec3(color.r, color.g, color.b);
            if (in.Get(AI_MATKEY_OPACITY, value) == AI_SUCCESS) out.alpha = value;
        }
        if (in.Get(AI_MATKEY_COLOR_EMISSIVE, color) == AI_SUCCESS) out.emissive = glm::vec3(color.r, color.g, color.b);
        if (in.Get(AI_MATKEY_METALLIC_FACTOR, value) == AI_SUCCESS) out.metallic = value;
        if (in.Get(AI_MATKEY_ROUGHNESS_FACTOR, value) == AI_SUCCESS) {
            out.roughness = value;
            // The exponent of the same width, for Phong shading.
            out.shininess = std::clamp(2.0f / std::max(value * value, 1e-3f) - 2.0f, 1.0f, 1000.0f);
            out.specular = glm::mix(glm::vec3(0.04f), out.baseColor, out.metallic);
        } else if (in.Get(AI_MATKEY_SHININESS, value) == AI_SUCCESS && value > 0.0f) {
            out.shininess = std::max(1.0f, value);
            out.roughness = roughnessOf(value);
            if (in.Get(AI_MATKEY_COLOR_SPECULAR, color) == AI_SUCCESS)
                out.specular = glm::vec3(color.r, color.g, color.b);
        }
        int twoSided = 0;
        if (in.Get(AI_MATKEY_TWOSIDED, twoSided) == AI_SUCCESS) out.doubleSided = twoSided != 0;
        if (in.Get(AI_MATKEY_GLTF_TEXTURE_SCALE(aiTextureType_NORMALS, 0), value) == AI_SUCCESS)
            out.normalScale = value;
        if (in.Get(AI_MATKEY_GLTF_ALPHACUTOFF, value) == AI_SUCCESS) out.alphaCutoff = value;
    }

    int texture(const aiMaterial& in, aiTextureType type, bool srgb) {
        aiString path;
        if (in.GetTexture(type, 0, &path) != AI_SUCCESS || path.length == 0) return -1;
        if (const aiTexture* embedded = m_source.GetEmbeddedTexture(path.C_Str())) {
            const std::string key = "embedded texture " + textOf(path);
            return m_set.add(key, srgb, [embedded, key] { return decodeEmbedded(*embedded, key); });
        }
        return m_picker.pick(textOf(path), srgb);
    }

    const aiScene& m_source;
    TextureSet& m_set;
    TexturePicker& m_picker;
};
}  // namespace

void readSceneMaterials(const aiScene& source, const std::filesystem::path& folder, std::vector<Material>& materials,
                        std::vector<Texture>& textures, std::vector<std::string>& warnings) {
    TextureSet set;
    TexturePicker picker(set, folder, warnings);
    SceneMaterialReader reader(source, set, picker);
    for (unsigned i = 0; i < source.mNumMaterials; ++i) materials.push_back(reader.read(*source.mMaterials[i]));
    textures = set.decode(warnings);
    for (unsigned i = 0; i < source.mNumMaterials; ++i) {
        dropEmptyTextures(materials[i], textures);
        moveNormalMap(materials[i], textures, warnings);
        aiString mode;
        if (source.mMaterials[i]->Get(AI_MATKEY_GLTF_ALPHAMODE, mode) != AI_SUCCESS)
            guessAlphaMode(materials[i], textures);
        else if (textOf(mode) == "MASK")
            materials[i].alphaMode = AlphaMode::Mask;
        else if (textOf(mode) == "BLEND")
            materials[i].alphaMode = AlphaMode::Blend;
    }
    compactTextures(textures, materials);
}

}  // namespace ombrage
