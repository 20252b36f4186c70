// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "scene/gltf_materials.h"
#include "scene/gltf_nodes.h"
#include "scene/model_file.h"

namespace ombrage {

/// Adds the meshes that the placed nodes show: one per primitive, shared by the nodes that show it. Skins and morph
/// targets are applied as the file's own pose and weights say. Points and lines are left out with a warning.
/// @throws Error(Input) with the JSON path where an accessor or an index does not fit.
void readGltfMeshes(GltfDocument& document, const std::vector<GltfNode>& nodes, const std::vector<GltfUv>& materialUvs,
                    ModelFile& model);

}  // namespace ombrage
