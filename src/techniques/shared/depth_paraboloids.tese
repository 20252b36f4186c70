// SPDX-License-Identifier: MIT
// World positions for depth_paraboloids.geom.
layout(triangles, equal_spacing) in;

in vec3 e_position[];
out vec3 t_position;

#ifdef ALPHA_MASK
in vec2 e_uv[];
in uint e_instance[];
out vec2 t_uv;
flat out uint t_instance;
#endif

void main() {
    vec3 w = gl_TessCoord;
    t_position = e_position[0] * w.x + e_position[1] * w.y + e_position[2] * w.z;
    gl_Position = vec4(t_position, 1.0);
#ifdef ALPHA_MASK
    t_uv = e_uv[0] * w.x + e_uv[1] * w.y + e_uv[2] * w.z;
    t_instance = e_instance[0];
#endif
}
