// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "scene/gltf_document.h"

namespace ombrage {

/// A node of the shown scene, and where it stands.
struct GltfNode {
    std::size_t index = 0;
    glm::dmat4 worldFromNode{1.0};
};

/// The nodes of the scene that the file shows ("scene", else the first; without scenes every node without a parent),
/// parents first. @throws Error(Input) for references to nodes that are not there, nodes with two parents, cycles, and
/// nodes more than 256 deep.
std::vector<GltfNode> placedNodes(const GltfDocument& document);

}  // namespace ombrage
