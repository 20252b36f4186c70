// SPDX-License-Identifier: MIT
// Whether a triangle of a volume makes a tile one of the boundary (Aila and Akenine-Moller 2004, section 3.1).
#include "shared/volume_tiles.glsl"

flat in vec3 v_edges[3];
flat in vec3 v_depth;
flat in vec2 v_depthRange;
flat in float v_hasRim;

layout(binding = 5) uniform sampler2D t_cells;
layout(location = 0) out vec2 o_class;   // boundary, dark

const float kMargin = 1e-4;   // of a distance: beside it rounding could tell surface and side apart in another way

void main() {
    ivec2 tile = ivec2(gl_FragCoord.xy);
    vec2 cell = texelFetch(t_cells, tile, 0).xy;
    if (cell.y == 0.0) discard;   // nothing but sky
    vec2 middle = tileMiddle(tile), reach = tileReach();

    // The tile lies outside of none of the three edges.
    for (int i = 0; i < 3; ++i)
        if (dot(v_edges[i].xy, middle) + v_edges[i].z + dot(abs(v_edges[i].xy), reach) < 0.0) discard;

    // The depths of the triangle's plane over the tile, no more than the triangle has.
    float at = dot(v_depth.xy, middle) + v_depth.z, change = dot(abs(v_depth.xy), reach);
    float farthest = max(at - change, v_depthRange.x), nearest = min(at + change, v_depthRange.y);
    // Behind all surfaces it crosses no ray to them.
    if (nearest < cell.x * (1.0 - kMargin)) discard;
    // Before all of them it changes the count of all pixels alike, but where it begins: other edges are shared with
    // sides that change it by the opposite.
    if (farthest > cell.y * (1.0 + kMargin)) {
        float rim = dot(v_edges[2].xy, middle) + v_edges[2].z;
        if (v_hasRim == 0.0 || abs(rim) > dot(abs(v_edges[2].xy), reach)) discard;
    }
    o_class = vec2(1.0, 0.0);
}
