// SPDX-License-Identifier: MIT
// Casters flattened onto a plane along the light (Blinn 1988). With P the plane and L towards the light, both homogeneous, the
// shadow of p is (P.L) p - (P.p) L: it lies in the plane, for P.((P.L) p - (P.p) L) = 0, and on the line from L through p. As a
// matrix that is (P.L) I - L P^T; with P = (0, 0, 1, 0) it gives x' = (L_z x - z L_x) / (L_z - L_w z), the case of the plane z = 0.
#include "ombrage/vertex.glsl"

uniform vec4 u_plane;          // P, turned so that P.L > 0
uniform vec4 u_toward;         // L: (position, 1), or (direction to the sun, 0)
uniform float u_tolerance_m;   // what is no higher is the plane itself

out float gl_ClipDistance[2];

#ifdef ALPHA_MASK
layout(location = 3) in vec2 a_uv;
out vec2 v_uv;
flat out uint v_instance;
#endif

void main() {
    vec3 p_world = positionWorld(a_position);
    precise float height_m = dot(u_plane.xyz, p_world) + u_plane.w;
    precise float lightHeight = dot(u_plane, u_toward);
    precise vec4 shadow = lightHeight * vec4(p_world, 1.0) - height_m * u_toward;
    gl_Position = clipFromPosition(frame.clipFromWorld, shadow);
    // The shadow's w falls to 0 at the light's height. Above it the line meets the plane behind the light: an anti-shadow.
    // With a reversed infinite far plane clip z is near * w, and the far plane alone cuts there too; no other projection does.
    gl_ClipDistance[0] = shadow.w;
    // What lies under the plane, or in it, shades no point of it.
    gl_ClipDistance[1] = height_m - u_tolerance_m;
#ifdef ALPHA_MASK
    v_uv = a_uv;
    v_instance = a_instance;
#endif
}
