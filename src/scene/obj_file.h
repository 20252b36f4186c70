// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "scene/model_file.h"

namespace ombrage {

/// Reads a Wavefront OBJ file's content and the MTL files that it names: polygons of any number of corners, concave
/// ones too; indices from the front and (negative) from the end; lines continued by a backslash; LF, CR LF and CR;
/// colours behind the vertices' positions. One mesh per material. Points, lines, curves and faces of two corners are
/// left out with a warning; so are materials and material files that are missing. Normals that are missing stay zero.
/// @throws Error(Input) with file and line where a number or an index is wrong.
ModelFile readObj(const std::string& content, const std::filesystem::path& file);

}  // namespace ombrage
