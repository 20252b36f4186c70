// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <ombrage/scene.h>

namespace ombrage {

/// Which texture coordinates a material of a glTF file uses: a set, and KHR_texture_transform's offset, rotation and
/// scale.
struct GltfUv {
    int set = 0;
    glm::vec2 offset{0.0f};
    float rotation_rad = 0.0f;
    glm::vec2 scale{1.0f};
    bool operator==(const GltfUv&) const = default;
    bool isIdentity() const { return offset == glm::vec2(0.0f) && rotation_rad == 0.0f && scale == glm::vec2(1.0f); }
    glm::vec2 apply(const glm::vec2& uv) const;
};

/// What the model library does not hand on, or only changed: lights and cameras in world space, and texture
/// coordinates.
struct GltfExtras {
    std::vector<GltfUv> materialUvs;  ///< by material, of the first texture that it has
    std::vector<Light> lights;
    std::vector<Camera> cameras;
    std::vector<std::string> warnings;
};

/// Reads the JSON part of a .gltf or .glb file's content. Parts that are not as they should be are left out, with a
/// warning.
GltfExtras readGltfExtras(const std::string& content);

}  // namespace ombrage
