// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "scene/model_file.h"

namespace ombrage {

/// Reads what this library has no reader of its own for (FBX, 3DS, COLLADA, STL, OFF, ...) through the model library.
/// Meshes are not yet completed. @throws Error(Input) naming the file.
ModelFile importModel(const std::filesystem::path& file);

}  // namespace ombrage
