// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "scene/model_file.h"

namespace ombrage {

/// Reads a glTF 2.0 file's content (.gltf or .glb) with its buffers, pictures, lights and cameras. Skinned and morphed
/// meshes stand as the file poses them. @throws Error(Input) naming the file and the JSON path of what is wrong.
ModelFile readGltf(const std::string& content, const std::filesystem::path& file);

}  // namespace ombrage
