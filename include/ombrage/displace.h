// SPDX-License-Identifier: MIT
#pragma once

#include <ombrage/scene.h>

namespace ombrage {

/// The most triangles that displaced() makes unless told otherwise.
inline constexpr std::size_t kMostDisplacedTriangles = std::size_t(16) << 20;

/// The scene with its height maps made geometry: what bump and normal maps stand for. Surfaces with a height map are divided until no
/// edge is longer than one and a half of the map's texels and moved along their normals by height * heightScale_uv, in metres as long as a
/// unit of texture coordinates is there; the map's mean height stays where the flat surface was. Those materials lose
/// their height and normal maps, all else stays, instances and their order too. Where texture coordinates or normals break off along an edge
/// the two sides part, and recesses show a gap where another surface meets them.
/// @throws Error(Usage) where that takes more than `mostTriangles`.
Scene displaced(const Scene& scene, std::size_t mostTriangles = kMostDisplacedTriangles);

}  // namespace ombrage
