// SPDX-License-Identifier: MIT
// Corners of shadow volumes. The index stream holds codes: vertex * 2, plus 1 for that vertex at infinity, away from the light.
#include "ombrage/vertex.glsl"

layout(std430, binding = 3) readonly buffer LocalPositions { float b_localPositions[]; };

uniform vec4 u_toward;      // towards the light: (position, 1), or (direction to the sun, 0)
uniform float u_infinity;   // w of points at infinity: 0; above 0 for orthographic cameras, which cannot show them

void main() {
    int vertex = (gl_VertexID >> 1) * 3;
    vec3 p_local = vec3(b_localPositions[vertex], b_localPositions[vertex + 1], b_localPositions[vertex + 2]);
    vec3 p_world = positionWorld(a_instance, p_local);
    vec4 p = vec4(p_world, 1.0);
    // Everitt and Kilgard 2002, section 5.1: V * L.w - L, at infinity along the ray from the light.
    if ((gl_VertexID & 1) != 0) p = vec4(p_world * u_toward.w - u_toward.xyz, u_infinity);
    gl_Position = clipFromPosition(frame.clipFromWorld, p);
}
