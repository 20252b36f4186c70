// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "scene/gltf_document.h"
#include "scene/model_file.h"

namespace ombrage {

/// Which texture coordinates a material of a glTF file uses: a set, and KHR_texture_transform's offset, rotation and
/// scale.
struct GltfUv {
    int set = 0;
    glm::vec2 offset{0.0f};
    float rotation_rad = 0.0f;
    glm::vec2 scale{1.0f};
    bool differ = false;  ///< another texture of the material lies differently
    bool operator==(const GltfUv&) const = default;
    bool isIdentity() const { return offset == glm::vec2(0.0f) && rotation_rad == 0.0f && scale == glm::vec2(1.0f); }
    glm::vec2 apply(const glm::vec2& uv) const;
};

/// Reads the materials (metallic-roughness, or the diffuse part of KHR_materials_pbrSpecularGlossiness) and their
/// pictures into the model. Returns, by material, the texture coordinates of the first texture that it has.
std::vector<GltfUv> readGltfMaterials(GltfDocument& document, ModelFile& model);

}  // namespace ombrage
