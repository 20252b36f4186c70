// SPDX-License-Identifier: MIT
// Corners of shadow volumes: w is 1 for a corner of the caster and 0 for the same corner at infinity, away from the light.
#define POSITION_TYPE vec4
#include "ombrage/vertex.glsl"

uniform vec4 u_toward;      // towards the light: (position, 1), or (direction to the sun, 0)
uniform float u_infinity;   // w of points at infinity: 0; above 0 for orthographic cameras, which cannot show them

void main() {
    vec3 p_world = positionWorld(a_position.xyz);
    vec4 p = vec4(p_world, 1.0);
    // Everitt and Kilgard 2002, section 5.1: V * L.w - L, at infinity along the ray from the light.
    if (a_position.w == 0.0) p = vec4(p_world * u_toward.w - u_toward.xyz, u_infinity);
    gl_Position = clipFromPosition(frame.clipFromWorld, p);
}
