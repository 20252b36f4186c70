// SPDX-License-Identifier: MIT
// One step of jump flooding (Rong and Tan 2006): every pixel takes from nine pixels u_step apart the edge that reaches it best,
// by distance over radius.
#include "shadow/volume-blur/penumbra.glsl"

layout(location = 0) out uvec2 o_edge;

layout(binding = 5) uniform usampler2D t_edges;

uniform int u_step;

// Edges are handed on a little farther than they reach, for those that come round another.
const float kFarther = 1.5;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy), last = ivec2(frame.viewport.xy) - 1;
    o_edge = uvec2(kNoEdge, 0u);
    float best = kFarther;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            ivec2 at = pixel + ivec2(x, y) * u_step;
            if (any(lessThan(at, ivec2(0))) || any(greaterThan(at, last))) continue;
            uvec2 edge = texelFetch(t_edges, at, 0).xy;
            if (edge.x == kNoEdge) continue;
            float radius_px = max(unpackHalf2x16(edge.y).x, 0.5);
            float reach = distance(vec2(edge.x & 0xffffu, edge.x >> 16), vec2(pixel)) / radius_px;
            if (reach < best) {
                best = reach;
                o_edge = edge;
            }
        }
}
