// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "scene/model_file.h"

namespace ombrage {

/// Reads a PLY file's content: ASCII, little or big endian; faces of any number of corners and triangle strips;
/// normals, texture coordinates (of vertices, or of the corners of faces) and colours where there are any; the texture
/// that a comment names. Normals and tangents that are missing stay so.
/// @throws Error(Input) naming the file and the element, also for point clouds.
ModelFile readPly(const std::string& content, const std::filesystem::path& file);

}  // namespace ombrage
