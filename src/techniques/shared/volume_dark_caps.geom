// SPDX-License-Identifier: MIT
// A triangle becomes a dark cap, if it casts.
layout(triangles) in;
#include "shared/volume_geometry.glsl"
#include "shared/volume_edges.glsl"

layout(triangle_strip, max_vertices = 3) out;

void main() {
    uint caster = v_in[0].caster;
    int weight = weightOf(caster, uint(gl_PrimitiveIDIn));
    if (weight == 0 || (b_casters[caster].flags & CASTER_FAR_ENDS) == 0u) return;
    bool outwards = facesOut(caster, weight);
    emitFar(0);
    emitFar(outwards ? 2 : 1);
    emitFar(outwards ? 1 : 2);
    EndPrimitive();
}
