// SPDX-License-Identifier: MIT
// One level of the variance-guided a-trous filter (Schied et al. 2017, section 4.3 and 4.4): 5 x 5 taps of the B3 spline, u_step
// pixels apart.
#include "filter/svgf/params"
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"
#include "shared/edge_stops.glsl"

layout(binding = 5) uniform sampler2D t_level;   // value and variance
uniform int u_step;                              // 2^level pixels

noperspective in vec2 v_uv;
layout(location = 0) out vec2 o_level;
layout(location = 1) out float o_value;   // where one level makes the history and the image

const float kSpline[3] = float[](3.0 / 8.0, 1.0 / 4.0, 1.0 / 16.0);
const float kSmall[2] = float[](1.0 / 2.0, 1.0 / 4.0);
// Where values farther apart than this no longer mix nothing is done: a quarter of a step of 8 bits.
const float kLeastReach = 1.0 / 1024.0;

// g3x3 of equation 5: the variance under a small Gaussian, for it is noisy itself.
float varianceAround(ivec2 px, ivec2 last) {
    float sum = 0.0;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
            sum += kSmall[abs(x)] * kSmall[abs(y)] * texelFetch(t_level, clamp(px + ivec2(x, y), ivec2(0), last), 0).g;
    return sum;
}

vec2 filtered(ivec2 px, vec2 center) {
    float depth = gbufferDepthAt(v_uv);
    if (depth == 0.0) return center;
    ivec2 last = ivec2(frameViewport.xy) - 1;
    float reach = params.sigma_l * sqrt(varianceAround(px, last));
    if (reach < kLeastReach) return center;
    float perValue = kLog2E / reach;
    EdgeStops stops = edgeStopsAt(v_uv, depth, params.sigma_z, params.sigma_n);

    // Equation 1 for the values, and 2 for the variance of a weighted sum.
    float weight = kSpline[0] * kSpline[0], total = weight;
    vec2 sum = vec2(weight, weight * weight) * center;
    for (int y = -2; y <= 2; ++y)
        for (int x = -2; x <= 2; ++x) {
            ivec2 at = px + u_step * ivec2(x, y);
            if ((x == 0 && y == 0) || any(lessThan(at, ivec2(0))) || any(greaterThan(at, last))) continue;
            vec2 uv = (vec2(at) + 0.5) * frameViewport.zw;
            float depthThere = gbufferDepthAt(uv);
            if (depthThere == 0.0) continue;
            vec2 there = texelFetch(t_level, at, 0).rg;
            float exponent = edgeStopExponent(stops, uv, depthThere) - perValue * abs(there.r - center.r);
            weight = kSpline[abs(x)] * kSpline[abs(y)] * exp2(exponent);
            sum += vec2(weight, weight * weight) * there;
            total += weight;
        }
    return sum / vec2(total, total * total);
}

void main() {
    ivec2 px = ivec2(v_uv * frameViewport.xy);
    o_level = filtered(px, texelFetch(t_level, px, 0).rg);
    o_value = o_level.r;
}
