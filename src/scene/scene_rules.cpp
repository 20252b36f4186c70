// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/loaded_scene.h"

namespace ombrage {

namespace {
bool isIndex(int index, std::size_t count) {
    return index >= 0 && std::size_t(index) < count;
}

bool isTexture(int index, const Scene& scene) {
    return index == -1 || isIndex(index, scene.textures.size());
}

/// Enumerations read from bytes may hold anything.
template <typename Enum>
bool isOneOf(Enum value, Enum last) {
    const auto number = std::int64_t(value);
    return number >= 0 && number <= std::int64_t(last);
}

bool isWhole(const Texture& texture) {
    return texture.width > 0 && texture.height > 0 &&
           std::uint64_t(texture.width) * std::uint64_t(texture.height) <= texture.rgba.size() / 4 &&
           texture.rgba.size() == std::size_t(texture.width) * std::size_t(texture.height) * 4;
}

bool isWhole(const Mesh& mesh) {
    const std::size_t count = mesh.positions.size();
    return mesh.normals.size() == count && mesh.tangents.size() == count && mesh.uvs.size() == count &&
           (mesh.colors.empty() || mesh.colors.size() == count) && count <= std::numeric_limits<std::uint32_t>::max() &&
           mesh.indices.size() % 3 == 0;
}

bool isFinite(const glm::dmat4& m) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(m[column][row])) return false;
    return true;
}
}  // namespace

std::string brokenRule(const Scene& scene) {
    for (const Texture& texture : scene.textures)
        if (!isWhole(texture)) return "a texture's size is not that of its texels";
    for (const Material& m : scene.materials) {
        if (!isOneOf(m.alphaMode, AlphaMode::Blend)) return "a material's alpha mode is unknown";
        for (const int index :
             {m.baseColorTexture, m.normalTexture, m.heightTexture, m.metallicRoughnessTexture, m.emissiveTexture})
            if (!isTexture(index, scene)) return "a material's texture does not exist";
    }
    for (const Mesh& mesh : scene.meshes) {
        if (!isWhole(mesh)) return "a mesh's arrays differ in length";
        if (!isIndex(mesh.material, scene.materials.size())) return "a mesh's material does not exist";
        const auto largest = std::max_element(mesh.indices.begin(), mesh.indices.end());
        if (largest != mesh.indices.end() && *largest >= mesh.positions.size()) return "a vertex does not exist";
    }
    for (const Instance& instance : scene.instances) {
        if (!isIndex(instance.mesh, scene.meshes.size())) return "an instance's mesh does not exist";
        if (!isIndex(instance.model, scene.models.size())) return "an instance's model does not exist";
        if (!isFinite(instance.worldFromLocal)) return "an instance's place is not finite";
    }
    for (const Light& light : scene.lights) {
        if (!isOneOf(light.type, LightType::Rect)) return "a light's type is unknown";
        for (const int model : light.excludedModels)
            if (!isIndex(model, scene.models.size())) return "a light excludes a model that does not exist";
    }
    for (const Animation& animation : scene.animations)
        for (const int instance : animation.instances)
            if (!isIndex(instance, scene.instances.size())) return "an animation moves an instance that does not exist";
    if (scene.cameras.empty() || scene.lights.empty()) return "there is no camera or no light";
    return {};
}

}  // namespace ombrage
