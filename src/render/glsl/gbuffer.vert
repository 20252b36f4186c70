// SPDX-License-Identifier: MIT
// Defines as in gbuffer.frag.
#include "ombrage/vertex.glsl"

layout(location = 1) in vec3 a_normal;
#if defined(NORMAL_MAP) || defined(HEIGHT_MAP)
layout(location = 2) in vec4 a_tangent;
out vec4 v_tangent;
#endif
#ifdef UV
layout(location = 3) in vec2 a_uv;
out vec2 v_uv;
#endif

out vec3 v_normal;
flat out uvec4 v_surface;   // packed albedo, packed material, first triangle, material

void main() {
    vec3 p_world = positionWorld(a_position);
    gl_Position = clipFromPosition(frame.clipFromWorld, vec4(p_world, 1.0));

    // The cofactors of the matrix turn normals as its inverse transpose does, but for the determinant's size.
    bool mirrored = (a_flags & INSTANCE_MIRRORED) != 0u;
    v_normal = cross(a_axisY, a_axisZ) * a_normal.x + cross(a_axisZ, a_axisX) * a_normal.y + cross(a_axisX, a_axisY) * a_normal.z;
    if (mirrored) v_normal = -v_normal;
    v_surface = a_surface;
#if defined(NORMAL_MAP) || defined(HEIGHT_MAP)
    v_tangent = vec4(mat3(a_axisX, a_axisY, a_axisZ) * a_tangent.xyz, mirrored ? -a_tangent.w : a_tangent.w);
#endif
#ifdef UV
    v_uv = a_uv;
#endif
}
