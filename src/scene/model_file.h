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

struct ModelFileOptions {
    std::filesystem::path skin;  ///< a picture for an MD2 model in place of its own
};

/// Reads a model with its textures: OBJ with MTL, glTF 2 (.gltf, .glb), PLY and MD2 by readers of this library,
/// whatever else the model library knows (FBX, 3DS, COLLADA, STL, ...) through that. Textures and material files that
/// are missing become warnings; indices and places outside their tables are errors.
/// @throws Error(Input) naming the file, and the line or place in it, when it cannot be read or holds no usable
/// triangle.
ModelFile readModelFile(const std::filesystem::path& file, const ModelFileOptions& options = {});

}  // namespace ombrage
