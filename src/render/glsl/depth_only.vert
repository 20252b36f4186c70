// SPDX-License-Identifier: MIT
// Depth of the scene from any view. ALPHA_MASK also passes what the alpha test needs.
#include "ombrage/vertex.glsl"

uniform mat4 u_clipFromWorld[1];

#ifdef ALPHA_MASK
layout(location = 3) in vec2 a_uv;
out vec2 v_uv;
flat out uint v_instance;
#endif

void main() {
    vec3 p_world = positionWorld(a_position);
    gl_Position = clipFromPosition(u_clipFromWorld[0], vec4(p_world, 1.0));
#ifdef ALPHA_MASK
    v_uv = a_uv;
    v_instance = a_instance;
#endif
}
