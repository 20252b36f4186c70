// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <ombrage/scene.h>

namespace ombrage::patterns {

/// Textures made in code, the same on every machine: whole numbers decide them. All repeat without a seam.

/// A number in [0, 1) from two whole ones.
float noise(std::uint32_t a, std::uint32_t b);

/// A lattice of slats `slat` of a cell wide, one cell large: opacity 0 between them.
Texture lattice(float slat);

/// One leaf, its stalk in the middle of the bottom edge: opacity 0 around it.
Texture leaf();

/// Heights of a wall of bricks, four courses of two bricks with rounded rims and a rough face.
Texture brickHeights();

/// Heights of square floor tiles, two by two, with worn edges.
Texture tileHeights();

/// The tangent-space normal map of a height map, with heights of `scale_uv` in units of texture coordinates.
Texture normalsOf(const Texture& heights, float scale_uv);

}  // namespace ombrage::patterns
