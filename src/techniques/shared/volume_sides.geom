// SPDX-License-Identifier: MIT
// An edge becomes the sides of the volumes that it bounds: none, one or two.
layout(lines) in;
#include "shared/volume_geometry.glsl"
#include "shared/volume_edges.glsl"

layout(triangle_strip, max_vertices = 8) out;

void main() {
    uint caster = v_in[0].caster;
    int count = sidesAt(caster, b_pairs[b_casters[caster].firstPair + uint(gl_PrimitiveIDIn)]);
    if (count == 0) return;

    // The side below the edge from a to b of a cap that is counter-clockwise seen from the light runs from b to a.
    bool turned = (count < 0) != ((b_casters[caster].flags & CASTER_MIRRORED) != 0u);
    int a = turned ? 1 : 0, b = 1 - a;
#ifdef TILE_BOUNDS
    emitTileBounds(gl_in[b].gl_Position, gl_in[a].gl_Position, farCorner(a), true);
    if ((b_casters[caster].flags & CASTER_FAR_ENDS) != 0u)
        emitTileBounds(gl_in[b].gl_Position, farCorner(a), farCorner(b), false);
#else
    for (int i = 0; i < abs(count); ++i) {
        emitNear(b);
        emitNear(a);
        if ((b_casters[caster].flags & CASTER_FAR_ENDS) != 0u) emitFar(b);
        emitFar(a);
        EndPrimitive();
    }
#endif
}
