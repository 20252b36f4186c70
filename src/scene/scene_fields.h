// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <type_traits>

#include <ombrage/scene.h>

namespace ombrage {

/// The members of a scene's structs, in order, handed to `archive(members...)`. Each struct is taken apart by a
/// structured binding, so a member that is added to one does not compile until it is listed here, and with it in
/// everything that is written to disk.
template <typename T, typename Struct>
concept Is = std::same_as<std::remove_const_t<T>, Struct>;

template <typename Archive, Is<Texture> T>
void fields(Archive& archive, T& texture) {
    auto& [name, width, height, srgb, rgba] = texture;
    archive(name, width, height, srgb, rgba);
}

template <typename Archive, Is<Material> T>
void fields(Archive& archive, T& material) {
    auto& [name, baseColor, alpha, specular, shininess, metallic, roughness, emissive, alphaMode, alphaCutoff,
           doubleSided, baseColorTexture, normalTexture, heightTexture, metallicRoughnessTexture, emissiveTexture,
           normalScale, heightScale_uv] = material;
    archive(name, baseColor, alpha, specular, shininess, metallic, roughness, emissive, alphaMode, alphaCutoff,
            doubleSided, baseColorTexture, normalTexture, heightTexture, metallicRoughnessTexture, emissiveTexture,
            normalScale, heightScale_uv);
}

template <typename Archive, Is<Mesh> T>
void fields(Archive& archive, T& mesh) {
    auto& [name, positions, normals, tangents, uvs, colors, indices, material] = mesh;
    archive(name, positions, normals, tangents, uvs, colors, indices, material);
}

template <typename Archive, Is<Instance> T>
void fields(Archive& archive, T& instance) {
    auto& [mesh, model, worldFromLocal] = instance;
    archive(mesh, model, worldFromLocal);
}

template <typename Archive, Is<Model> T>
void fields(Archive& archive, T& model) {
    auto& [name, file, casts, receives] = model;
    archive(name, file, casts, receives);
}

template <typename Archive, Is<Light> T>
void fields(Archive& archive, T& light) {
    auto& [name, type, position, direction, color, intensity, radius_m, angle_rad, size_m, range_m, inner_rad,
           outer_rad, excludedModels] = light;
    archive(name, type, position, direction, color, intensity, radius_m, angle_rad, size_m, range_m, inner_rad,
            outer_rad, excludedModels);
}

template <typename Archive, Is<Camera> T>
void fields(Archive& archive, T& camera) {
    auto& [name, position, target, up, fovY_rad, orthoHeight_m] = camera;
    archive(name, position, target, up, fovY_rad, orthoHeight_m);
}

template <typename Archive, Is<Animation> T>
void fields(Archive& archive, T& animation) {
    auto& [type, light, period_s, instances, pivot, axis, amplitude_rad, phase] = animation;
    archive(type, light, period_s, instances, pivot, axis, amplitude_rad, phase);
}

template <typename Archive, Is<Scene> T>
void fields(Archive& archive, T& scene) {
    auto& [name, description, textures, materials, meshes, models, instances, lights, cameras, animations, techniques,
           ambient, aoRadius_m, warnings] = scene;
    archive(name, description, textures, materials, meshes, models, instances, lights, cameras, animations, techniques,
            ambient, aoRadius_m, warnings);
}

}  // namespace ombrage
