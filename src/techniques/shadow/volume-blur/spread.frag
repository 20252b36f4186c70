// SPDX-License-Identifier: MIT
// One step of jump flooding (Rong and Tan 2006): every pixel takes from nine pixels u_step apart the edge that reaches it best,
// by distance over radius. Edges of its own surface come first; others are carried past it, and dropped at last.
#include "shadow/volume-blur/penumbra.glsl"

layout(location = 0) out uvec2 o_edge;

layout(binding = 5) uniform usampler2D t_edges;
layout(binding = 6) uniform sampler2D t_hard;

uniform int u_step;

// Worse than any of the own surface.
const float kOther = 1e3;

// Slope of a bent receiver against the tangent plane that is one surface still.
const float kBend = 0.3;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy), last = ivec2(frame.viewport.xy) - 1;
    o_edge = uvec2(kNoEdge, 0u);
    float best = 2.0 * kOther, depth = gbufferDepth(pixel);
    if (depth == 0.0) depth = 1e-9;
    vec3 p_view = positionInView(pixel, depth), n_view = gbufferGeometricNormal(pixel) * mat3(frame.worldFromView);
    float pixel_m = pixelSizeAt(viewDepthFromDepth(depth));
    // In the shadow the nearest edge counts, however narrow its penumbra: beyond that the shadow is whole.
    bool isDark = texelFetch(t_hard, pixel, 0).r == 0.0;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            ivec2 at = pixel + ivec2(x, y) * u_step;
            if (any(lessThan(at, ivec2(0))) || any(greaterThan(at, last))) continue;
            uvec2 edge = texelFetch(t_edges, at, 0).xy;
            if (edge.x == kNoEdge) continue;
            float radius_px = isDark ? params.reach : max(unpackHalf2x16(edge.y).x, 0.5);
            ivec2 edgeAt = ivec2(edge.x & 0xffffu, edge.x >> 16);
            float apart_px = distance(vec2(edgeAt), vec2(pixel)), reach = apart_px / radius_px;
            if (reach >= min(best, kFarther)) continue;
            float rise_m = abs(dot(n_view, positionInView(edgeAt, gbufferDepth(edgeAt)) - p_view));
            if (rise_m > (params.plane_tolerance + kBend * apart_px) * pixel_m) reach += kOther;
            if (reach < best && (reach < kOther || u_step > 1)) {
                best = reach;
                o_edge = edge;
            }
        }
}
