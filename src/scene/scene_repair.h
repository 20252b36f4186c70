// SPDX-License-Identifier: MIT
#pragma once

#include <ombrage/scene.h>

namespace ombrage {

/// Leaves out what no picture and no truth can use, wherever the scene comes from, and says so in its warnings:
/// triangles with a corner that is not finite or without area (dropBadTriangles), and those that repeat another of
/// their mesh with the same sides out; instances that repeat another of their model (shape, look and place). Attributes
/// that are no numbers get usable values; vertices that no triangle needs go. Meshes that have none of this stay as
/// they are, bit for bit.
void repairScene(Scene& scene);

}  // namespace ombrage
