// SPDX-License-Identifier: MIT
#include "ombrage/vertex.glsl"

layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec4 a_tangent;
layout(location = 3) in vec2 a_uv;

out vec3 v_position;
out vec3 v_normal;
out vec4 v_tangent;
out vec2 v_uv;
flat out uint v_instance;
#ifdef VERTEX_COLORS
layout(location = 5) in vec4 a_color;
out vec3 v_color;
#endif

void main() {
    vec3 p_world = positionWorld(a_instance, a_position);
    InstanceData instance = b_instances[a_instance];
    v_position = p_world;
    v_normal = mat3(instance.normalFromLocal) * a_normal;
    v_tangent = vec4(mat3(instance.worldFromLocal) * a_tangent.xyz, (instance.flags & 1u) != 0u ? -a_tangent.w : a_tangent.w);
    v_uv = a_uv;
#ifdef VERTEX_COLORS
    v_color = a_color.rgb;
#endif
    v_instance = a_instance;
    gl_Position = clipFromPosition(frame.clipFromWorld, vec4(p_world, 1.0));
}
