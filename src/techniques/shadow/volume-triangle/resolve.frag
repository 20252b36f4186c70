// SPDX-License-Identifier: MIT
// From the marks of nodes down to the pixels: 0 where the pixel or any node above it is in shadow. SHOW_LEVEL: the level that
// was marked, counted from 1; 0 where the light comes.
#include "shadow/volume-triangle/nodes.glsl"

#ifdef SHOW_LEVEL
layout(location = 0) out uint o_level;
#else
layout(location = 0) out float o_visibility;
#endif

bool isMarked(int level, ivec2 child, uint words) {
    uint index = indexOf(child);
    return (b_nodes[entryOf(level, child >> 3) + words + (index >> 5)] >> (index & 31u) & 1u) != 0u;
}

void main() {
    ivec2 px = ivec2(gl_FragCoord.xy);
    uint shadowedBy = isMarked(1, px, ENTRY_DONE) ? 1u : 0u;
    for (int level = 2; level <= TOP_LEVEL; ++level)
        if (isMarked(level, px >> (3 * (level - 1)), ENTRY_DARK)) shadowedBy = uint(level);
    if (!isMarked(1, px, ENTRY_ASKED)) shadowedBy = 0u;
#ifdef SHOW_LEVEL
    o_level = shadowedBy;
#else
    o_visibility = 0.0;
    if (shadowedBy == 0u) discard;
#endif
}
