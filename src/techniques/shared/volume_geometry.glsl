// SPDX-License-Identifier: MIT
// What geometry shaders of volumes emit.
#include "shared/volume_ends.glsl"

in VertexData {
    vec3 p_world;
    flat uint caster;
} v_in[];

#ifdef EXTRUSION
out float v_extrusion;   // as in shared/shadow_volume.vert
#endif

void emitNear(int i) {
#ifdef EXTRUSION
    v_extrusion = 0.0;
#endif
    gl_Position = gl_in[i].gl_Position;
    EmitVertex();
}

void emitFar(int i) {
#ifdef EXTRUSION
    v_extrusion = 1.0;
#endif
    gl_Position = clipFromPosition(frame.clipFromWorld, farEnd(v_in[i].p_world));
    EmitVertex();
}
