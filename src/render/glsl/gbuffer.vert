// SPDX-License-Identifier: MIT
// Defines as in gbuffer.frag.
#ifdef PIXEL_SAMPLES
#define INSIDE centroid
#else
#define INSIDE
#endif
#include "ombrage/vertex.glsl"

#include "ombrage/octahedral.glsl"

layout(location = 1) in vec3 a_normal;
// Of the triangle that this vertex ends, alone of all vertices (render/faceted_mesh.h).
layout(location = 12) in vec3 a_facetNormal;
layout(location = 13) in uint a_triangle;
#if defined(NORMAL_MAP) || defined(HEIGHT_MAP)
layout(location = 2) in vec4 a_tangent;
INSIDE out vec4 v_tangent;
#endif
#ifdef UV
layout(location = 3) in vec2 a_uv;
INSIDE out vec2 v_uv;
#endif
#ifdef VERTEX_COLORS
layout(location = 11) in vec4 a_color;
INSIDE out vec3 v_color;
#endif

INSIDE out vec3 v_normal;
flat out uvec4 v_surface;   // packed albedo, octahedral normal of the counter-clockwise side, triangle, material
#ifdef MATERIAL_PLANE
flat out uint v_material;   // packed
#endif

void main() {
    vec3 p_world = positionWorld(a_position);
    gl_Position = clipFromPosition(frame.clipFromWorld, vec4(p_world, 1.0));

    // The cofactors of the matrix turn normals as its inverse transpose does, but for the determinant's size.
    bool mirrored = (a_flags & INSTANCE_MIRRORED) != 0u;
    mat3 cofactors = mat3(cross(a_axisY, a_axisZ), cross(a_axisZ, a_axisX), cross(a_axisX, a_axisY));
    v_normal = cofactors * a_normal;
    if (mirrored) v_normal = -v_normal;
    // The normal by the order of the corners mirrors itself.
    v_surface = uvec4(a_surface.x, packSnorm2x16(octahedralFromVector(cofactors * a_facetNormal)), a_surface.z + a_triangle, a_surface.w);
#ifdef MATERIAL_PLANE
    v_material = a_surface.y;
#endif
#if defined(NORMAL_MAP) || defined(HEIGHT_MAP)
    v_tangent = vec4(mat3(a_axisX, a_axisY, a_axisZ) * a_tangent.xyz, mirrored ? -a_tangent.w : a_tangent.w);
#endif
#ifdef UV
    v_uv = a_uv;
#endif
#ifdef VERTEX_COLORS
    v_color = a_color.rgb;
#endif
}
