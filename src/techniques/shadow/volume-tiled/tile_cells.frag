// SPDX-License-Identifier: MIT
// The depths between which the surfaces of a tile lie, farthest first (reversed: it is the smaller); 0, 0 where there are
// none. As depth the middle, for the count that holds for the whole tile.
#include "ombrage/frame.glsl"
#include "ombrage/bindings.glsl"

layout(binding = UNIT_DEPTH) uniform sampler2D t_depth;
layout(location = 0) out vec2 o_cell;

void main() {
    ivec2 first = ivec2(gl_FragCoord.xy) * ONTO_TILES;
    ivec2 end = min(first + ONTO_TILES, ivec2(frame.viewport.xy));
    vec2 cell = vec2(2.0, 0.0);
    for (int y = first.y; y < end.y; ++y)
        for (int x = first.x; x < end.x; ++x) {
            float depth = texelFetch(t_depth, ivec2(x, y), 0).r;
            if (depth > 0.0) cell = vec2(min(cell.x, depth), max(cell.y, depth));
        }
    if (cell.y == 0.0) cell.x = 0.0;
    o_cell = cell;
    gl_FragDepth = 0.5 * (cell.x + cell.y);
}
