// SPDX-License-Identifier: MIT
// The one way from a vertex to the screen: every pass that must meet another's depth calls positionWorld() and
// clipFromPosition(), so that equal inputs give equal bits.
#include "ombrage/frame.glsl"
#include "ombrage/instances.glsl"

layout(location = 0) in vec3 a_position;
layout(location = 4) in uint a_instance;   // per draw, through baseInstance

invariant gl_Position;

vec3 positionWorld(uint instance, vec3 p_local) {
    mat4 m = b_instances[instance].worldFromLocal;
    precise vec3 p = m[0].xyz * p_local.x + m[1].xyz * p_local.y + m[2].xyz * p_local.z + m[3].xyz;
    return p;
}

// Homogeneous: w = 0 is a direction.
vec4 clipFromPosition(mat4 clipFromWorld, vec4 p_world) {
    precise vec4 clip = clipFromWorld[0] * p_world.x + clipFromWorld[1] * p_world.y + clipFromWorld[2] * p_world.z +
                        clipFromWorld[3] * p_world.w;
    return clip;
}
