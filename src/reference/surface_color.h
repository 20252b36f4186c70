// SPDX-License-Identifier: MIT
#pragma once

#include <ombrage/scene.h>

#include "scene/flat_scene.h"

namespace ombrage {

/// What a surface is coloured with at weights of its triangle's second and third vertex, linear.
struct SurfaceColor {
    glm::vec3 base{0.0f}, emissive{0.0f};
};
SurfaceColor surfaceColor(const Scene& scene, const FlatScene& flat, std::uint32_t triangle, glm::vec2 barycentric);

}  // namespace ombrage
