// SPDX-License-Identifier: MIT
// World positions for depth_layers.geom.
#include "ombrage/vertex.glsl"

out vec3 g_position;

#ifdef ALPHA_MASK
layout(location = 3) in vec2 a_uv;
out vec2 g_uv;
flat out uint g_instance;
#endif

void main() {
    g_position = positionWorld(a_position);
    gl_Position = vec4(g_position, 1.0);
#ifdef ALPHA_MASK
    g_uv = a_uv;
    g_instance = a_instance;
#endif
}
