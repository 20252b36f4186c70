// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "scene/flat_scene.h"

namespace ombrage {

/// dot(normal, p) = offset_m, in the space moved by the scene's origin.
struct Plane {
    glm::dvec3 normal{0, 1, 0};  ///< unit
    double offset_m = 0;
    double heightOf(const glm::dvec3& p) const { return glm::dot(normal, p) - offset_m; }
};

/// The flat surfaces of a scene that are large enough for a shadow to be looked at.
struct PlanarSurfaces {
    /// Floors first (within 2.6 degrees of horizontal, more of their area facing up than down), then all others, each
    /// kind by falling area. The normal is on the side to which more of the area faces.
    std::vector<Plane> planes;
    std::vector<double> area_m2;        ///< of each plane's triangles
    std::vector<std::uint8_t> planeOf;  ///< per global triangle 1 + its plane, 0: in none of them
};

/// A plane counts when its triangles hold this share of the area of all instances that receive shadows.
inline constexpr double kLeastPlanarShare = 1.0 / 50;

/// How far a corner may lie off its plane: 8 roundings to float of the largest coordinate.
double planeTolerance_m(const FlatScene& flat);

/// Whether the three corners lie in the plane, to the tolerance.
bool liesIn(const Plane& plane, const FlatScene& flat, std::uint32_t triangle, double tolerance_m);

PlanarSurfaces findPlanarSurfaces(const FlatScene& flat);

}  // namespace ombrage
