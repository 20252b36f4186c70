// SPDX-License-Identifier: MIT
#include "scene/model_materials.h"

#include <algorithm>
#include <cmath>

#include <assimp/material.h>
#include <assimp/scene.h>

#include "core/strings.h"
#include "scene/material_textures.h"

namespace ombrage {

namespace {
float roughnessOf(float shininess) {
    return std::sqrt(2.0f / (std::max(shininess, 0.0f) + 2.0f));
}

Material fromMtl(const std::string& name, const MtlMaterial& mtl, MaterialTextures& pictures) {
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
    material.baseColorTexture = pictures.pick(mtl.diffuseMap.file, true, mtl.folder);
    material.emissiveTexture = pictures.pick(mtl.emissiveMap.file, true, mtl.folder);
    material.normalTexture = pictures.pick(mtl.normalMap.file, false, mtl.folder);
    material.heightTexture = pictures.pick(mtl.heightMap.file, false, mtl.folder);
    material.heightScale_uv *= mtl.heightMap.bumpMultiplier;
    return material;
}

}  // namespace

void readObjMaterials(const std::vector<std::string>& names, const MtlLibrary& library,
                      const std::filesystem::path& folder, ModelFile& model) {
    MaterialTextures pictures(folder, model.warnings);
    std::vector<int> opacity;
    bool clamped = false;
    for (const std::string& name : names) {
        const auto found = library.find(name);
        const MtlMaterial mtl = found == library.end() ? MtlMaterial{} : found->second;
        if (found == library.end() && !library.empty() && name != "DefaultMaterial")
            model.warnings.push_back("material '" + name + "' is not in the material file; a grey one stands in");
        model.materials.push_back(fromMtl(name, mtl, pictures));
        opacity.push_back(pictures.pick(mtl.opacityMap.file, false, mtl.folder));
        clamped = clamped || mtl.diffuseMap.clamp || mtl.opacityMap.clamp;
    }
    if (clamped) model.warnings.push_back("the texture option -clamp is not used: textures repeat");
    pictures.finish(model, opacity);
    for (std::size_t i = 0; i < model.materials.size(); ++i)
        if (model.materials[i].alphaMode == AlphaMode::Opaque) guessAlphaMode(model.materials[i], model.textures);
    compactTextures(model.textures, model.materials);
}

Material plainMaterial(const std::string& name, bool colored) {
    Material material;
    material.name = name;
    if (colored) material.baseColor = glm::vec3(1.0f);
    material.specular = glm::vec3(0.0f);
    return material;
}

void setColorTexture(ModelFile& model, const std::filesystem::path& file) {
    MaterialTextures pictures(file.parent_path(), model.warnings);
    model.materials[0].baseColorTexture = pictures.pick(file.filename().string(), true);
    pictures.finish(model);
    guessAlphaMode(model.materials[0], model.textures);
    compactTextures(model.textures, model.materials);
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
    SceneMaterialReader(const aiScene& source, MaterialTextures& pictures) : m_source(source), m_pictures(pictures) {}

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
    }

    int texture(const aiMaterial& in, aiTextureType type, bool srgb) {
        aiString path;
        if (in.GetTexture(type, 0, &path) != AI_SUCCESS || path.length == 0) return -1;
        if (const aiTexture* embedded = m_source.GetEmbeddedTexture(path.C_Str())) {
            const std::string key = "embedded texture " + textOf(path);
            return m_pictures.add(key, srgb, [embedded, key] { return decodeEmbedded(*embedded, key); });
        }
        return m_pictures.pick(textOf(path), srgb);
    }

    const aiScene& m_source;
    MaterialTextures& m_pictures;
};
}  // namespace

void readSceneMaterials(const aiScene& source, const std::filesystem::path& folder, ModelFile& model) {
    MaterialTextures pictures(folder, model.warnings);
    SceneMaterialReader reader(source, pictures);
    for (unsigned i = 0; i < source.mNumMaterials; ++i) model.materials.push_back(reader.read(*source.mMaterials[i]));
    pictures.finish(model);
    for (Material& material : model.materials) guessAlphaMode(material, model.textures);
    compactTextures(model.textures, model.materials);
}

}  // namespace ombrage
