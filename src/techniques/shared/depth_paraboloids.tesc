// SPDX-License-Identifier: MIT
// Cuts edges so short that their pictures on a paraboloid, arcs of circles, bend by less than half a texel.
#include "shared/light_views.glsl"
layout(vertices = 3) out;

uniform float u_segment_rad;   // longest arc that may be drawn as a line
uniform float u_mostParts;

in vec3 g_position[];
out vec3 e_position[];

#ifdef ALPHA_MASK
in vec2 g_uv[];
flat in uint g_instance[];
out vec2 e_uv[];
out uint e_instance[];
#endif

// By the edge's two ends alone, in whatever order, so that triangles on both sides of it cut it alike.
float levelOf(vec3 a, vec3 b) {
    if (a.x > b.x || (a.x == b.x && (a.y > b.y || (a.y == b.y && a.z > b.z)))) {
        vec3 other = a;
        a = b;
        b = other;
    }
    // Nowhere along it do equal parts span more than where it is nearest to the light.
    vec3 along = b - a, start = a - VIEW_ORIGIN(0).xyz;
    float t = clamp(-dot(start, along) / max(dot(along, along), 1e-30), 0.0, 1.0);
    float nearest_m = length(start + t * along);
    return clamp(ceil(length(along) / max(nearest_m * u_segment_rad, 1e-30)), 1.0, u_mostParts);
}

void main() {
    e_position[gl_InvocationID] = g_position[gl_InvocationID];
#ifdef ALPHA_MASK
    e_uv[gl_InvocationID] = g_uv[gl_InvocationID];
    e_instance[gl_InvocationID] = g_instance[gl_InvocationID];
#endif
    if (gl_InvocationID == 0) {
        vec3 levels = vec3(levelOf(g_position[1], g_position[2]), levelOf(g_position[2], g_position[0]), levelOf(g_position[0], g_position[1]));
        gl_TessLevelOuter[0] = levels.x;
        gl_TessLevelOuter[1] = levels.y;
        gl_TessLevelOuter[2] = levels.z;
        gl_TessLevelInner[0] = max(levels.x, max(levels.y, levels.z));
    }
}
