// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "render/frame_context.h"
#include "scene/planar_surfaces.h"

namespace ombrage::planar {

/// The planes of a scene and, per triangle, which it lies in, for receivers.frag.
struct ReceiverPlanes {
    std::vector<Plane> planes;
    float tolerance_m = 0;
    bool empty = true;   ///< no triangle lies in any
    gl::Buffer planeOf;  ///< a byte per global triangle: 1 + its plane, 0: in none

    ReceiverPlanes(const FlatScene& flat, PlanarSurfaces surfaces);
};

/// Found once per scene, whatever the number of lights.
struct FoundPlanes : ReceiverPlanes {
    explicit FoundPlanes(const GpuScene& scene) : ReceiverPlanes(scene.flat(), findPlanarSurfaces(scene.flat())) {}
};

/// The one plane dot(normal, p) = offset_m of the world. @throws Error(Usage) for a normal of length 0.
ReceiverPlanes givenPlane(const FlatScene& flat, const glm::vec3& normal, float offset_m);

/// A plane that shows shadows of a light.
struct ActivePlane {
    int id = 0;             ///< 1 + its place among the planes: its number in the stencil
    glm::vec4 plane{0.0f};  ///< turned to the light: dot(xyz, p) + w is the height over it
    float lightHeight = 0;  ///< dot(plane, towards the light): of a lamp in metres, of a sun a sine
    float highest_m = 0;    ///< no caster rises higher
};

/// Which casters a plane without clipping has, too.
struct ClipRules {
    bool atLight = true, atPlane = true;
};

/// Those of the first `count` planes that the light and the eye see from one side, with a caster that can shade them.
std::vector<ActivePlane> activePlanes(const FrameContext& frame, const LightFrame& light,
                                      const ReceiverPlanes& receivers, int count, const ClipRules& clip);

}  // namespace ombrage::planar
