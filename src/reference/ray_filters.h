// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include <embree3/rtcore.h>

#include "reference/ray_scene.h"

namespace ombrage {

/// What the filters must know of the rays under way. Embree hands the base back, so it comes first.
struct RayContext {
    RTCIntersectContext base;
    const Scene* scene;
    const FlatScene* flat;
    const std::uint32_t* const* triangles;  ///< per geometry of Embree, the global ids of its triangles
    const Ray* rays;                        ///< by the id that Embree keeps of each
    float recheckBelow_m;
    std::vector<std::pair<std::uint32_t, float>>* crossed;  ///< collects triangles and distances instead of stopping

    std::uint32_t triangleOf(unsigned geometry, unsigned primitive) const { return triangles[geometry][primitive]; }
};

/// Takes away hits on the holes of cut-out materials; set for their geometry alone.
void filterHoles(const RTCFilterFunctionNArguments* args);

/// Takes away hits that do not count for their ray: its own triangle, instances that it does not see, surfaces that
/// hold its origin.
void filterHits(const RTCFilterFunctionNArguments* args);

/// Who asks what lies around a point.
struct NearQuery {
    const RayContext* context;
    glm::dvec3 point;
    double radius_m;
    std::uint32_t ownTriangle;
    bool found = false;
};

/// For rtcPointQuery with a NearQuery: finds whether a triangle comes nearer than the radius; in doubt it does.
bool seeNear(RTCPointQueryFunctionArguments* args);

}  // namespace ombrage
