// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <ombrage/scene.h>

#include "scene/mtl_file.h"

struct aiScene;

namespace ombrage {

/// The materials of a Wavefront file, by the names that the model library found in it.
void readObjMaterials(const std::vector<std::string>& names, const MtlLibrary& library,
                      const std::filesystem::path& folder, std::vector<Material>& materials,
                      std::vector<Texture>& textures, std::vector<std::string>& warnings);

/// The materials of any other file (metallic-roughness where it has them), embedded textures included.
void readSceneMaterials(const aiScene& source, const std::filesystem::path& folder, std::vector<Material>& materials,
                        std::vector<Texture>& textures, std::vector<std::string>& warnings);

}  // namespace ombrage
