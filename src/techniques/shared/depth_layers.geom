// SPDX-License-Identifier: MIT
// Sends each triangle to those of six layers whose view it touches.
layout(triangles) in;
layout(triangle_strip, max_vertices = 18) out;

uniform mat4 u_clipFromWorld[6];

in vec3 g_position[];

#ifdef ALPHA_MASK
in vec2 g_uv[];
flat in uint g_instance[];
out vec2 v_uv;
flat out uint v_instance;
#endif

void main() {
    for (int layer = 0; layer < 6; ++layer) {
        vec4 clip[3];
        for (int i = 0; i < 3; ++i) clip[i] = u_clipFromWorld[layer] * vec4(g_position[i], 1.0);

        // Outside one side plane or behind the light with all three corners: not in this view.
        bvec4 outside = bvec4(true);
        bool behind = true;
        for (int i = 0; i < 3; ++i) {
            outside = bvec4(outside.x && clip[i].x > clip[i].w, outside.y && clip[i].x < -clip[i].w,
                            outside.z && clip[i].y > clip[i].w, outside.w && clip[i].y < -clip[i].w);
            behind = behind && clip[i].w <= 0.0;
        }
        if (any(outside) || behind) continue;

        for (int i = 0; i < 3; ++i) {
            gl_Layer = layer;
            gl_Position = clip[i];
#ifdef ALPHA_MASK
            v_uv = g_uv[i];
            v_instance = g_instance[i];
#endif
            EmitVertex();
        }
        EndPrimitive();
    }
}
