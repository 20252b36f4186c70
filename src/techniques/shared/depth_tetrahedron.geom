// SPDX-License-Identifier: MIT
// Sends each triangle to those of a tetrahedron's four faces that it touches: two to a layer, each clipped to its half of the square.
layout(triangles) in;
layout(triangle_strip, max_vertices = 12) out;

uniform mat4 u_clipFromWorld[4];

in vec3 g_position[];

#ifdef ALPHA_MASK
in vec2 g_uv[];
flat in uint g_instance[];
out vec2 v_uv;
flat out uint v_instance;
#endif

void main() {
    for (int face = 0; face < 4; ++face) {
        vec4 clip[3];
        float inside[3];
        bool isOutside = true, isBehind = true;
        float side = face % 2 == 0 ? -1.0 : 1.0;
        for (int i = 0; i < 3; ++i) {
            clip[i] = u_clipFromWorld[face] * vec4(g_position[i], 1.0);
            inside[i] = side * (clip[i].x + clip[i].y);
            isOutside = isOutside && inside[i] < 0.0;
            isBehind = isBehind && clip[i].w <= 0.0;
        }
        if (isOutside || isBehind) continue;

        for (int i = 0; i < 3; ++i) {
            gl_Layer = face / 2;
            gl_Position = clip[i];
            gl_ClipDistance[0] = inside[i];
#ifdef ALPHA_MASK
            v_uv = g_uv[i];
            v_instance = g_instance[i];
#endif
            EmitVertex();
        }
        EndPrimitive();
    }
}
