// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <ombrage/scene.h>

namespace ombrage {

/// Spheres of about this many triangles together on a floor, under spot lights that each reach all of them: what costs
/// are measured on as triangles or lights grow.
Scene spheresScene(std::size_t triangles, int lights);

}  // namespace ombrage
