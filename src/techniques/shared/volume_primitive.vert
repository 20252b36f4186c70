// SPDX-License-Identifier: MIT
// Edges and triangles of casters on their way to shared/volume_sides.geom and shared/volume_dark_caps.geom.
#include "ombrage/vertex.glsl"
#include "shared/volume_ends.glsl"

out VertexData {
    vec3 p_world;
    flat uint caster;
} v_out;

void main() {
    v_out.p_world = positionWorld(a_position);
    v_out.caster = a_instance;
    gl_Position = clipFromPosition(frame.clipFromWorld, nearEnd(v_out.p_world, a_instance));
}
