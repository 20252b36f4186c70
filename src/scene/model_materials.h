// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/model_file.h"
#include "scene/mtl_file.h"

struct aiScene;

namespace ombrage {

/// Gives the model the materials of a Wavefront file, by the names that its faces use.
void readObjMaterials(const std::vector<std::string>& names, const MtlLibrary& library,
                      const std::filesystem::path& folder, ModelFile& model);

/// Gives the model the materials of a file that the model library read, embedded textures included.
void readSceneMaterials(const aiScene& source, const std::filesystem::path& folder, ModelFile& model);

/// A matte material for files without any: grey, or white where textures or vertices colour it.
Material plainMaterial(const std::string& name, bool colored);

/// Makes a picture the colour texture of the model's one material; holes in its alpha cut the surface out. A picture
/// that cannot be read is a warning.
void setColorTexture(ModelFile& model, const std::filesystem::path& file);

}  // namespace ombrage
