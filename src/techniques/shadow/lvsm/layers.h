// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

namespace ombrage::lvsm {

/// Cuts the depths of a map into layers: the cut of all whose depths differ least from their layers' means, in the sum
/// of squares. Lloyd's relaxation (Lauritzen, McCool 2008, section 4.3) seeks the same by steps; in one dimension the
/// best cut is found outright.
/// @param histogram counts of depths in equal bins over z in [-1,1]
/// @return the ends of the layers, from -1 to 1, each within the gap between two depths; as many layers as asked for,
/// or
///         as there are different depths
std::vector<float> placeLayers(const std::vector<std::uint32_t>& histogram, int layers);

/// Equal layers.
std::vector<float> evenLayers(int layers);

/// What a layer's moments span: its ends, and beyond them `overlap` times the thinner of the two neighbours' depth.
/// @return x where warped depth is 0, y warped depth per z, z the layer's end; for `count` layers, those that `ends`
/// does
///         not have hold nothing
std::vector<glm::vec4> layerSpans(const std::vector<float>& ends, float overlap, int count);

}  // namespace ombrage::lvsm
