// SPDX-License-Identifier: MIT
#include "scene/gltf_file.h"

#include "scene/gltf_lights.h"
#include "scene/gltf_materials.h"
#include "scene/gltf_meshes.h"

namespace ombrage {

ModelFile readGltf(const std::string& content, const std::filesystem::path& file) {
    GltfDocument document(content, file);
    ModelFile model;
    const std::vector<GltfNode> nodes = placedNodes(document);
    const std::vector<GltfUv> uvs = readGltfMaterials(document, model);
    readGltfMeshes(document, nodes, uvs, model);
    readGltfLights(document, nodes, model);
    std::vector<bool> used(uvs.size(), false);
    for (const Mesh& mesh : model.meshes)
        if (mesh.material >= 0) used[std::size_t(mesh.material)] = true;
    for (std::size_t i = 0; i < uvs.size(); ++i)
        if (used[i] && uvs[i].differ)
            model.warnings.push_back("material '" + model.materials[i].name +
                                     "' places its textures differently; all are placed as the first");
    // Primitives without a material share a plain one, as glTF 2.0 gives it.
    for (Mesh& mesh : model.meshes) {
        if (mesh.material >= 0) continue;
        if (model.materials.size() == uvs.size()) {
            Material material;
            material.name = "default";
            material.baseColor = glm::vec3(1.0f);
            material.roughness = 1.0f;
            model.materials.push_back(material);
        }
        mesh.material = int(uvs.size());
    }
    if (const GltfJson& animations = gltfMember(document.root(), "animations");
        animations.is_array() && !animations.empty())
        model.warnings.push_back("the file's animations are not played");
    return model;
}

}  // namespace ombrage
