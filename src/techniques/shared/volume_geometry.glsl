// SPDX-License-Identifier: MIT
// What geometry shaders of volumes emit.
#include "shared/volume_ends.glsl"

in VertexData {
    vec3 p_world;
    flat uint caster;
} v_in[];

void emitNear(int i) {
    gl_Position = gl_in[i].gl_Position;
    EmitVertex();
}

void emitFar(int i) {
    gl_Position = clipFromPosition(frame.clipFromWorld, farEnd(v_in[i].p_world));
    EmitVertex();
}
