// SPDX-License-Identifier: MIT
// The tiles of one class as quads, two triangles each.
#include "shared/volume_tiles.glsl"

layout(binding = 5) uniform sampler2D t_classes;
uniform int u_boundary;   // 1: those of the boundary, 0: dark ones

void main() {
    int tilesAcross = textureSize(t_classes, 0).x, index = gl_VertexID / 6, corner = gl_VertexID % 6;
    ivec2 tile = ivec2(index % tilesAcross, index / tilesAcross);
    vec2 kind = texelFetch(t_classes, tile, 0).rg;
    bool boundary = kind.r > 0.5;
    if (u_boundary != 0 ? !boundary : boundary || kind.g < 0.5) {
        gl_Position = vec4(0.0, 0.0, 0.0, -1.0);
        return;
    }
    const ivec2 offsets[6] = ivec2[6](ivec2(0, 0), ivec2(1, 0), ivec2(1, 1), ivec2(0, 0), ivec2(1, 1), ivec2(0, 1));
    vec2 pixel = vec2((tile + offsets[corner]) * ONTO_TILES);
    gl_Position = vec4(pixel * 2.0 * frame.viewport.zw - 1.0, 0.5, 1.0);
}
