// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <ombrage/scene.h>

namespace ombrage {

/// What a model file holds, in its own space. Indices are into this file's own lists.
struct ModelFile {
    struct Part {
        int mesh = 0;
        glm::dmat4 fileFromLocal{1.0};
    };
    std::vector<Texture> textures;
    std::vector<Material> materials;
    std::vector<Mesh> meshes;  ///< with normals, tangents and uvs, without bad triangles or unused vertices
    std::vector<Part> parts;
    std::vector<Light> lights;
    std::vector<Camera> cameras;
    std::vector<std::string> warnings;
};

/// Reads OBJ with MTL, glTF 2 (.gltf, .glb) and whatever else the model library knows (PLY, FBX, ...), textures
/// included. Textures and material files that are missing become warnings.
/// @throws Error(Input) naming the file when it cannot be read or holds no usable triangle.
ModelFile readModelFile(const std::filesystem::path& file);

}  // namespace ombrage
