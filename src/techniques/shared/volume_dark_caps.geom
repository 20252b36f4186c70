// SPDX-License-Identifier: MIT
// A triangle becomes a dark cap, if it casts.
layout(triangles) in;
#include "shared/volume_geometry.glsl"
#include "shared/volume_edges.glsl"

layout(triangle_strip, max_vertices = 4) out;

void main() {
    uint caster = v_in[0].caster;
    int weight = weightOf(caster, uint(gl_PrimitiveIDIn));
    if (weight == 0 || (b_casters[caster].flags & CASTER_FAR_ENDS) == 0u) return;
#ifdef TILE_BOUNDS
    emitTileBounds(farCorner(0), farCorner(1), farCorner(2), false);
#else
    bool outwards = facesOut(caster, weight);
    emitFar(0);
    emitFar(outwards ? 2 : 1);
    emitFar(outwards ? 1 : 2);
    EndPrimitive();
#endif
}
