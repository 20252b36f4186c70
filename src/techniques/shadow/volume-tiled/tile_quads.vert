// SPDX-License-Identifier: MIT
// The tiles of one class as quads, two triangles for each row of neighbours.
#include "shared/volume_tiles.glsl"

layout(binding = 5) uniform sampler2D t_classes;
uniform int u_boundary;   // 1: those of the boundary, 0: dark ones

bool isWanted(ivec2 tile) {
    vec2 kind = texelFetch(t_classes, tile, 0).rg;
    bool boundary = kind.r > 0.5;
    return u_boundary != 0 ? boundary : !boundary && kind.g > 0.5;
}

void main() {
    int tilesAcross = textureSize(t_classes, 0).x, index = gl_VertexID / 6, corner = gl_VertexID % 6;
    ivec2 tile = ivec2(index % tilesAcross, index / tilesAcross);
    // The first of a row stands for all of it.
    if (!isWanted(tile) || (tile.x > 0 && isWanted(tile - ivec2(1, 0)))) {
        gl_Position = vec4(0.0, 0.0, 0.0, -1.0);
        return;
    }
    int across = 1;
    while (tile.x + across < tilesAcross && isWanted(tile + ivec2(across, 0))) ++across;
    const ivec2 offsets[6] = ivec2[6](ivec2(0, 0), ivec2(1, 0), ivec2(1, 1), ivec2(0, 0), ivec2(1, 1), ivec2(0, 1));
    vec2 pixel = vec2((tile + offsets[corner] * ivec2(across, 1)) * ONTO_TILES);
    gl_Position = vec4(pixel * 2.0 * frame.viewport.zw - 1.0, 0.0, 1.0);
}
