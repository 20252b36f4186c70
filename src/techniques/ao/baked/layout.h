// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "scene/flat_scene.h"

namespace ombrage::baked {

/// Where values are kept: at the vertices, or in texels of a texture.
enum class Store { Vertex, Texel };

/// A triangle's block of (across + 1) x (up + 1) texels. Texel (i, j) lies at the weights
///   w2 = j / up, w1 = (1 - w2) i / across, w0 = 1 - w1 - w2
/// of the corners, so that rows run along the first edge and the last row is the third corner alone. Between its
/// texels' centres a texture's own bilinear filter interpolates: no block reads another's.
struct Block {
    std::uint8_t first = 0;  ///< of the triangle's corners, that comes first here; they keep their order
    std::uint16_t across = 1, up = 1;
    /// First texel of the front's and of the back's; one place where only one is kept.
    std::array<glm::uvec2, 2> place{};

    int texels() const { return (across + 1) * (up + 1); }
    /// The values are the vertices': neither side is longer than a texel.
    bool isCoarse() const { return across == 1 && up == 1; }
};

/// Blocks of all triangles in one texture.
struct Layout {
    std::vector<Block> blocks;  ///< per global triangle
    int width = 0, height = 0;
    float spacing_m = 0;        ///< between texels along any edge, at most; +inf for vertices
    std::vector<bool> hasBack;  ///< per instance: its back can be seen
};

/// Weights of the corners in the block's order.
glm::dvec3 weightsOf(const Block& block, int i, int j);

/// Blocks as fine as a number of samples for the texels of triangles larger than one texel allows. Store::Vertex makes
/// all of them small ones.
/// @param largest width and height of the texture
/// @throws Error(Environment) when they do not fit
Layout makeLayout(const FlatScene& flat, std::vector<bool> hasBack, Store store, std::uint64_t samples, int largest);

}  // namespace ombrage::baked
