// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "scene/gltf_nodes.h"
#include "scene/model_file.h"

namespace ombrage {

/// Adds the lights (KHR_lights_punctual) and cameras of the placed nodes, in world space. Those that are not as they
/// should be are left out, with a warning.
void readGltfLights(const GltfDocument& document, const std::vector<GltfNode>& nodes, ModelFile& model);

}  // namespace ombrage
