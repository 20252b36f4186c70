// SPDX-License-Identifier: MIT
// Sends each small triangle to the paraboloids that it touches, with its plane, from which the fragments take their depth.
#include "shared/light_views.glsl"
layout(triangles) in;
layout(triangle_strip, max_vertices = 6) out;

in vec3 t_position[];
flat out vec3 v_plane;   // 1 / distance along a unit direction is its product with it
flat out vec2 v_depths;  // least and greatest 1 / distance that its fragments may have
flat out int v_view;

#ifdef ALPHA_MASK
in vec2 t_uv[];
flat in uint t_instance[];
out vec2 v_uv;
flat out uint v_instance;
#endif

// How far beyond its half a paraboloid still draws, as a cosine: neighbours of the texels at its rim.
const float kBeyond = 0.1;

void main() {
    vec3 corners[3];
    float lengths[3];
    for (int i = 0; i < 3; ++i) {
        corners[i] = t_position[i] - VIEW_ORIGIN(0).xyz;
        lengths[i] = length(corners[i]);
    }
    vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    float offset = dot(normal, corners[0]);
    if (offset == 0.0) return;   // seen edge-on

    // A piece is small: its plane within half a texel of it is hardly nearer or farther than its corners, but where it is seen edge-on.
    float nearest_m = min(lengths[0], min(lengths[1], lengths[2])), farthest_m = max(lengths[0], max(lengths[1], lengths[2]));
    vec2 depths = vec2(0.8 / farthest_m, 1.1 / nearest_m);

    for (int view = 0; view < 2; ++view) {
        float inside[3];
        bool isOutside = true;
        for (int i = 0; i < 3; ++i) {
            inside[i] = dot(corners[i], VIEW_FORWARD(view).xyz) + kBeyond * lengths[i];
            isOutside = isOutside && inside[i] < 0.0;
        }
        if (isOutside) continue;
        for (int i = 0; i < 3; ++i) {
            gl_Layer = view;
            v_view = view;
            v_plane = normal / offset;
            v_depths = depths;
            float distance_m;
            vec2 uv = lightViewUv(view, t_position[i], distance_m);
            gl_Position = vec4(uv * 2.0 - 1.0, 0.5, 1.0);
            gl_ClipDistance[0] = inside[i] / lengths[i];
#ifdef ALPHA_MASK
            v_uv = t_uv[i];
            v_instance = t_instance[i];
#endif
            EmitVertex();
        }
        EndPrimitive();
    }
}
