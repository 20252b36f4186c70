// SPDX-License-Identifier: MIT
#include "scene/gltf_materials.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <ombrage/error.h>

#include "scene/material_textures.h"

namespace ombrage {

namespace {
GltfUv uvOf(const GltfJson& texture) {
    GltfUv uv;
    const GltfJson& transform = gltfMember(gltfMember(texture, "extensions"), "KHR_texture_transform");
    uv.set = int(gltfNumber(gltfMember(texture, "texCoord"), 0.0));
    uv.set = int(gltfNumber(gltfMember(transform, "texCoord"), uv.set));
    uv.offset = glm::vec2(gltfVector<2>(gltfMember(transform, "offset"), glm::dvec2(0.0)));
    uv.scale = glm::vec2(gltfVector<2>(gltfMember(transform, "scale"), glm::dvec2(1.0)));
    uv.rotation_rad = float(gltfNumber(gltfMember(transform, "rotation"), 0.0));
    return uv;
}

GltfUv materialUv(const GltfJson& material) {
    const GltfJson& pbr = gltfMember(material, "pbrMetallicRoughness");
    const GltfJson& glossy = gltfMember(gltfMember(material, "extensions"), "KHR_materials_pbrSpecularGlossiness");
    std::optional<GltfUv> first;
    bool differ = false;
    for (const GltfJson* texture : {&gltfMember(pbr, "baseColorTexture"), &gltfMember(glossy, "diffuseTexture"),
                                    &gltfMember(pbr, "metallicRoughnessTexture"),
                                    &gltfMember(material, "normalTexture"), &gltfMember(material, "emissiveTexture")}) {
        if (!texture->is_object()) continue;
        const GltfUv uv = uvOf(*texture);
        differ = differ || (first && *first != uv);
        if (!first) first = uv;
    }
    GltfUv result = first.value_or(GltfUv{});
    result.differ = differ;
    return result;
}

class MaterialReader {
public:
    MaterialReader(GltfDocument& document, MaterialTextures& pictures) : m_document(document), m_pictures(pictures) {}

    Material read(const GltfJson& json, const std::string& place) {
        Material material;
        material.name = gltfText(gltfMember(json, "name"), "");
        const GltfJson& pbr = gltfMember(json, "pbrMetallicRoughness");
        const GltfJson& glossy = gltfMember(gltfMember(json, "extensions"), "KHR_materials_pbrSpecularGlossiness");
        const bool isGlossy = glossy.is_object() && !pbr.is_object();
        const glm::dvec4 base = gltfVector<4>(
            isGlossy ? gltfMember(glossy, "diffuseFactor") : gltfMember(pbr, "baseColorFactor"), glm::dvec4(1.0));
        material.baseColor = glm::vec3(base);
        material.alpha = float(base.a);
        material.metallic = isGlossy ? 0.0f : float(gltfNumber(gltfMember(pbr, "metallicFactor"), 1.0));
        material.roughness = isGlossy ? 1.0f - float(gltfNumber(gltfMember(glossy, "glossinessFactor"), 1.0))
                                      : float(gltfNumber(gltfMember(pbr, "roughnessFactor"), 1.0));
        // The exponent of the same width and the colour of the same mirror, for Phong shading.
        const float squared = material.roughness * material.roughness;
        material.shininess = std::clamp(2.0f / std::max(squared, 1e-3f) - 2.0f, 1.0f, 1000.0f);
        material.specular = glm::mix(glm::vec3(0.04f), material.baseColor, material.metallic);
        material.emissive = glm::vec3(gltfVector<3>(gltfMember(json, "emissiveFactor"), glm::dvec3(0.0)));
        material.emissive *=
            float(gltfNumber(gltfMember(gltfMember(gltfMember(json, "extensions"), "KHR_materials_emissive_strength"),
                                        "emissiveStrength"),
                             1.0));
        material.doubleSided = gltfMember(json, "doubleSided") == true;

        const std::string mode = gltfText(gltfMember(json, "alphaMode"), "OPAQUE");
        if (mode == "MASK")
            material.alphaMode = AlphaMode::Mask;
        else if (mode == "BLEND")
            material.alphaMode = AlphaMode::Blend;
        else if (mode != "OPAQUE")
            m_document.fail(place + "/alphaMode", "'" + mode + "' is none of OPAQUE, MASK and BLEND");
        material.alphaCutoff = float(gltfNumber(gltfMember(json, "alphaCutoff"), 0.5));

        const char* colorKey = isGlossy ? "diffuseTexture" : "baseColorTexture";
        material.baseColorTexture = texture(isGlossy ? glossy : pbr, colorKey, true, place);
        material.metallicRoughnessTexture = texture(pbr, "metallicRoughnessTexture", false, place);
        material.normalTexture = texture(json, "normalTexture", false, place);
        material.normalScale = float(gltfNumber(gltfMember(gltfMember(json, "normalTexture"), "scale"), 1.0));
        material.emissiveTexture = texture(json, "emissiveTexture", true, place);
        return material;
    }

private:
    int texture(const GltfJson& owner, const char* key, bool srgb, const std::string& place) {
        const GltfJson& info = gltfMember(owner, key);
        if (!info.is_object()) return -1;
        const std::size_t number = m_document.find("textures", gltfMember(info, "index"), place + "/" + key + "/index");
        const std::string here = "/textures/" + std::to_string(number);
        const GltfJson& source = gltfMember(m_document.root()["textures"][number], "source");
        // A texture without a picture of its own has one in an extension that is not read.
        if (source.is_null())
            return m_pictures.add(here, srgb, [here]() -> Image {
                throw Error(ErrorCode::Input, "it has no PNG or JPEG picture", "", here);
            });
        return image(m_document.find("images", source, here + "/source"), srgb);
    }

    int image(std::size_t number, bool srgb) {
        const std::string place = "/images/" + std::to_string(number);
        const GltfJson& json = m_document.root()["images"][number];
        const std::string uri = gltfText(gltfMember(json, "uri"), "");
        if (!uri.empty() && uri.compare(0, 5, "data:") != 0) return m_pictures.pick(uri, srgb);
        std::string bytes;
        if (!uri.empty()) {
            bytes = m_document.resource(uri, place + "/uri");
        } else {
            const auto view = m_document.view(gltfMember(json, "bufferView"), place + "/bufferView");
            bytes.assign(reinterpret_cast<const char*>(view.data()), view.size());
        }
        return m_pictures.add(place, srgb, [bytes, place] {
            return decodeImage({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}, place);
        });
    }

    GltfDocument& m_document;
    MaterialTextures& m_pictures;
};
}  // namespace

glm::vec2 GltfUv::apply(const glm::vec2& uv) const {
    // KHR_texture_transform: offset * rotation * scale, turning counter-clockwise with v downwards.
    const glm::vec2 s = uv * scale;
    const float c = std::cos(rotation_rad), n = std::sin(rotation_rad);
    return offset + glm::vec2(c * s.x + n * s.y, c * s.y - n * s.x);
}

std::vector<GltfUv> readGltfMaterials(GltfDocument& document, ModelFile& model) {
    std::vector<GltfUv> uvs;
    MaterialTextures pictures(document.folder(), model.warnings);
    MaterialReader reader(document, pictures);
    const GltfJson& materials = gltfMember(document.root(), "materials");
    for (std::size_t i = 0; materials.is_array() && i < materials.size(); ++i) {
        const std::string place = "/materials/" + std::to_string(i);
        model.materials.push_back(reader.read(materials[i], place));
        uvs.push_back(materialUv(materials[i]));
    }
    pictures.finish(model);
    compactTextures(model.textures, model.materials);
    return uvs;
}

}  // namespace ombrage
