// SPDX-License-Identifier: MIT
// Triangles of sides and dark caps, whose corners shared/shadow_volume.vert has placed.
layout(triangles) in;
#include "shared/volume_tile_bounds.glsl"

layout(triangle_strip, max_vertices = 4) out;

in float v_isNear[];

void main() {
    // Sides have their edge of the caster first.
    bool hasRim = v_isNear[0] > 0.5 && v_isNear[1] > 0.5;
    emitTileBounds(gl_in[0].gl_Position, gl_in[1].gl_Position, gl_in[2].gl_Position, hasRim);
}
