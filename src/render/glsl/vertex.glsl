// SPDX-License-Identifier: MIT
// The one way from a vertex to the screen: every pass that must meet another's depth calls positionWorld() and
// clipFromPosition(), so that equal inputs give equal bits.
#include "ombrage/clip.glsl"
#include "ombrage/frame.glsl"
#include "ombrage/instances.glsl"

#ifndef POSITION_TYPE
#define POSITION_TYPE vec3
#endif
layout(location = 0) in POSITION_TYPE a_position;

// Per draw, through baseInstance: the instance, the columns of its world-from-local matrix, and what of it the G-buffer takes.
// Attributes, because a driver fetches them once per draw where it would fetch storage once per vertex.
layout(location = 4) in uint a_instance;
layout(location = 5) in vec3 a_axisX;
layout(location = 6) in vec3 a_axisY;
layout(location = 7) in vec3 a_axisZ;
layout(location = 8) in vec3 a_offset;
layout(location = 9) in uvec4 a_surface;   // packed albedo, packed material, first triangle, material
layout(location = 10) in uint a_flags;     // INSTANCE_...

invariant gl_Position;

vec3 positionWorld(vec3 p_local) {
    precise vec3 p = a_axisX * p_local.x + a_axisY * p_local.y + a_axisZ * p_local.z + a_offset;
    return p;
}
