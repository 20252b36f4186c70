// SPDX-License-Identifier: MIT
// Casters flattened onto a plane along the light (Blinn 1988). With P the plane and L towards the light, both homogeneous, the
// shadow of p is (P.L) p - (P.p) L: it lies in the plane, for P.((P.L) p - (P.p) L) = 0, and on the line from L through p. As a
// matrix that is (P.L) I - L P^T; with P = (0, 0, 1, 0) it gives x' = (L_z x - z L_x) / (L_z - L_w z), the case of the plane z = 0.
// NO_LIGHT_CLIP, NO_PLANE_CLIP: without one of the two cuts. UV, VERTEX_COLORS, SURFACE, HEIGHT, ON_PLANE: what the fragments ask for.
// EDGE_ON: some casters are edge-on to the lamp, and are left out.
#include "ombrage/vertex.glsl"

uniform vec4 u_plane;          // P, turned so that P.L > 0
uniform vec4 u_toward;         // L: (position, 1), or (direction to the sun, 0)
uniform float u_tolerance_m;   // what is no higher is the plane itself
uniform vec2 u_zoom;           // the picture's share of the target, which may have a border

out float gl_ClipDistance[2];

#ifdef UV
layout(location = 3) in vec2 a_uv;
out vec2 v_uv;
#endif
#ifdef VERTEX_COLORS
layout(location = 11) in vec4 a_color;
out vec3 v_color;
#endif
#ifdef SURFACE
flat out uvec2 v_surface;   // packed albedo, material
#endif
#ifdef HEIGHT
out float v_height_m;
#endif
#ifdef ON_PLANE
out vec4 v_shadow;
#endif
#ifdef EDGE_ON
// Of the triangle that this vertex ends, alone of all vertices (render/faceted_mesh.h).
layout(location = 13) in uint a_triangle;
layout(std430, binding = 4) readonly buffer EdgeOn { uint b_edgeOn[]; };   // a bit per global triangle
flat out uint v_isEdgeOn;
#endif

void main() {
    vec3 p_world = positionWorld(a_position);
    precise float height_m = dot(u_plane.xyz, p_world) + u_plane.w;
    precise float lightHeight = dot(u_plane, u_toward);
    precise vec4 shadow = lightHeight * vec4(p_world, 1.0) - height_m * u_toward;
#ifdef NO_LIGHT_CLIP
    // Vertex by vertex, S = L + a (V - L) with a of any sign: what is behind the lamp comes out on its other side. Homogeneous
    // points with w < 0 would be clipped by the viewport's own planes.
    shadow /= shadow.w;
    gl_ClipDistance[0] = 1.0;
#else
    // The shadow's w falls to 0 at the light's height. Above it the line meets the plane behind the light: an anti-shadow.
    // With a reversed infinite far plane clip z is near * w, and the far plane alone cuts there too; no other projection does.
    gl_ClipDistance[0] = shadow.w;
#endif
    gl_Position = clipFromPosition(frame.clipFromWorld, shadow);
    gl_Position.xy *= u_zoom;
    // What lies in the plane shades no point of it, and neither does what is under it.
#ifdef NO_PLANE_CLIP
    gl_ClipDistance[1] = abs(height_m) - u_tolerance_m;
#else
    gl_ClipDistance[1] = height_m - u_tolerance_m;
#endif
#ifdef EDGE_ON
    uint triangle = a_surface.z + a_triangle;
    v_isEdgeOn = b_edgeOn[triangle >> 5] >> (triangle & 31u) & 1u;
#endif
#ifdef UV
    v_uv = a_uv;
#endif
#ifdef VERTEX_COLORS
    v_color = a_color.rgb;
#endif
#ifdef SURFACE
    v_surface = a_surface.xw;
#endif
#ifdef HEIGHT
    v_height_m = height_m;
#endif
#ifdef ON_PLANE
    v_shadow = shadow;
#endif
}
