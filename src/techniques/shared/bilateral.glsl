// SPDX-License-Identifier: MIT
// The bilateral mean (Tomasi, Manduchi 1998) with a range weight that asks the geometry: beginBilateral(), addBilateral() for
// every neighbour, and the quotient of what they gathered.
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"
#include "shared/edge_stops.glsl"

layout(binding = 5) uniform sampler2D t_input;

struct Bilateral {
    EdgeStops stops;
    ivec2 px, last;          // the pixel, and the picture's last one
    float perStep2;          // of a squared distance over the picture, in an exponent of 2
    float sum, total;
};

// Of the pixel around `uv`, with the pixel itself gathered. False: it shows the sky, which keeps its value and is not used.
bool beginBilateral(out Bilateral b, vec2 uv, float sigma_px, float tolerance_px, float normalPower) {
    b.px = ivec2(uv * frameViewport.xy);
    b.last = ivec2(frameViewport.xy) - 1;
    b.perStep2 = -0.5 * kLog2E / (sigma_px * sigma_px);
    b.sum = texelFetch(t_input, b.px, 0).r;
    b.total = 1.0;
    float depth = gbufferDepthAt(uv);
    if (depth == 0.0) return false;
    b.stops = edgeStopsAt(uv, depth, tolerance_px, normalPower);
    return true;
}

// Gathers the pixel `step` away: the Gaussian of its distance over the picture, times what the edge stops leave.
void addBilateral(inout Bilateral b, ivec2 step) {
    ivec2 at = b.px + step;
    if (step == ivec2(0) || any(lessThan(at, ivec2(0))) || any(greaterThan(at, b.last))) return;
    vec2 uv = (vec2(at) + 0.5) * frameViewport.zw;
    float depth = gbufferDepthAt(uv);
    if (depth == 0.0) return;
    float weight = exp2(b.perStep2 * float(step.x * step.x + step.y * step.y) + edgeStopExponent(b.stops, uv, depth));
    b.sum += weight * texelFetch(t_input, at, 0).r;
    b.total += weight;
}
