// SPDX-License-Identifier: MIT
// The marks of tiles as a picture. SHOW_LEVEL: the topmost level that was marked, counted from 1; 0 where the light comes.
#include "shadow/volume-triangle/nodes.glsl"

#ifdef SHOW_LEVEL
layout(location = 0) out uint o_level;
#else
layout(location = 0) out float o_visibility;
#endif

void main() {
    ivec2 px = ivec2(gl_FragCoord.xy);
    bool isDark = isMarked(1, px, ENTRY_DONE);
#ifdef SHOW_LEVEL
    o_level = isDark ? 1u : 0u;
    for (int level = 2; level <= TOP_LEVEL; ++level)
        if (isDark && isMarked(level, px >> (3 * (level - 1)), ENTRY_DARK)) o_level = uint(level);
#else
    o_visibility = 0.0;
    if (!isDark) discard;
#endif
}
