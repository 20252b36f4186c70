// SPDX-License-Identifier: MIT
// What reaches a pixel: the blur's radius in pixels, or the distance from caster to receiver in metres.
#include "shadow/volume-blur/penumbra.glsl"

layout(location = 0) out float o_value;

layout(binding = 5) uniform usampler2D t_edges;

uniform int u_distance;   // 1: the distance

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    uvec2 edge = texelFetch(t_edges, pixel, 0).xy;
    o_value = 0.0;
    if (edge.x == kNoEdge) return;
    vec2 value = unpackHalf2x16(edge.y);
    float distance_m;
    directionToLight(positionOf(pixel, gbufferDepth(pixel)), distance_m);
    o_value = u_distance == 0 ? value.x : LIGHT_IS(LIGHT_SUN) ? value.y : value.y * distance_m;
}
