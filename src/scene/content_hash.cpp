// SPDX-License-Identifier: MIT
#include <ombrage/scene.h>

#include "core/hash.h"
#include "core/trace.h"

namespace ombrage {

namespace {
template <int N, typename T>
void hashVector(Hasher& hasher, const glm::vec<N, T, glm::defaultp>& v) {
    for (int i = 0; i < N; ++i) hasher.value(v[i]);
}

void hashMaterial(Hasher& hasher, const Material& m) {
    hashVector(hasher, m.baseColor);
    hasher.value(m.alpha);
    hashVector(hasher, m.specular);
    hasher.value(m.shininess);
    hasher.value(m.metallic);
    hasher.value(m.roughness);
    hashVector(hasher, m.emissive);
    hasher.value(m.alphaMode);
    hasher.value(m.alphaCutoff);
    hasher.value(m.doubleSided);
    for (const int texture :
         {m.baseColorTexture, m.normalTexture, m.heightTexture, m.metallicRoughnessTexture, m.emissiveTexture})
        hasher.value(texture);
    hasher.value(m.normalScale);
    hasher.value(m.heightScale_uv);
}

void hashMesh(Hasher& hasher, const Mesh& mesh) {
    hasher.array(mesh.positions);
    hasher.array(mesh.normals);
    hasher.array(mesh.tangents);
    hasher.array(mesh.uvs);
    hasher.array(mesh.colors);
    hasher.array(mesh.indices);
    hasher.value(mesh.material);
}

void hashLight(Hasher& hasher, const Light& light) {
    hasher.value(light.type);
    hashVector(hasher, light.position);
    hashVector(hasher, light.direction);
    hashVector(hasher, light.color);
    hasher.value(light.intensity);
    hasher.value(light.radius_m);
    hasher.value(light.angle_rad);
    hashVector(hasher, light.size_m);
    hasher.value(light.range_m);
    hasher.value(light.inner_rad);
    hasher.value(light.outer_rad);
    hasher.array(light.excludedModels);
}

void hashCamera(Hasher& hasher, const Camera& camera) {
    hashVector(hasher, camera.position);
    hashVector(hasher, camera.target);
    hashVector(hasher, camera.up);
    hasher.value(camera.fovY_rad);
    hasher.value(camera.orthoHeight_m.has_value());
    if (camera.orthoHeight_m) hasher.value(*camera.orthoHeight_m);
}
}  // namespace

std::string contentHash(const Scene& scene) {
    const TraceScope trace("hash scene");
    Hasher hasher;
    for (const std::size_t count :
         {scene.textures.size(), scene.materials.size(), scene.meshes.size(), scene.models.size(),
          scene.instances.size(), scene.lights.size(), scene.cameras.size(), scene.animations.size()})
        hasher.value(std::uint64_t(count));
    for (const Texture& texture : scene.textures) {
        hasher.value(texture.width);
        hasher.value(texture.height);
        hasher.value(texture.srgb);
        hasher.array(texture.rgba);
    }
    for (const Material& material : scene.materials) hashMaterial(hasher, material);
    for (const Mesh& mesh : scene.meshes) hashMesh(hasher, mesh);
    for (const Model& model : scene.models) {
        hasher.value(model.casts);
        hasher.value(model.receives);
    }
    for (const Instance& instance : scene.instances) {
        hasher.value(instance.mesh);
        hasher.value(instance.model);
        for (int column = 0; column < 4; ++column) hashVector(hasher, instance.worldFromLocal[column]);
    }
    for (const Light& light : scene.lights) hashLight(hasher, light);
    for (const Camera& camera : scene.cameras) hashCamera(hasher, camera);
    // An animation names its light; which one it is counts, not what it is called.
    for (const Animation& animation : scene.animations) {
        hasher.text(animation.type);
        hasher.value(animation.type == "orbit-light" ? scene.lightIndex(animation.light) : -1);
        hasher.value(animation.period_s);
        hasher.array(animation.instances);
        hashVector(hasher, animation.pivot);
        hashVector(hasher, animation.axis);
        hasher.value(animation.amplitude_rad);
        hasher.value(animation.phase);
    }
    hasher.value(scene.ambient);
    hasher.value(scene.aoRadius_m);
    return hasher.hex();
}

}  // namespace ombrage
