// SPDX-License-Identifier: MIT
// The marks of nodes brought down to their tiles: what is left of a tile's done pixels are those in shadow.
#include "shadow/volume-triangle/nodes.glsl"

layout(local_size_x = 64) in;

void main() {
    ivec2 tile = ivec2(int(gl_GlobalInvocationID.x), int(gl_GlobalInvocationID.y));
    if (tile.x >= gridOf(1).x) return;
    uint entry = entryOf(1, tile);
    bool isWhole = false;
    for (int level = 2; level <= TOP_LEVEL; ++level)
        if (isMarked(level, tile >> (3 * (level - 2)), ENTRY_DARK)) isWhole = true;
    for (uint word = 0u; word < 2u; ++word) {
        uint done = isWhole ? ~0u : b_nodes[entry + ENTRY_DONE + word];
        b_nodes[entry + ENTRY_DONE + word] = done & b_nodes[entry + ENTRY_ASKED + word];
    }
}
