// SPDX-License-Identifier: MIT
// One level of the edge-avoiding a-trous wavelet (Dammertz et al. 2010): 5 x 5 taps of the B3 spline, u_step pixels apart.
#include "filter/atrous/params"
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"
#include "shared/edge_stops.glsl"

layout(binding = 5) uniform sampler2D t_input;
uniform int u_step;          // 2^level pixels
uniform float u_perValue2;   // of a squared difference of values, in an exponent of 2; 0: values are not asked

noperspective in vec2 v_uv;
layout(location = 0) out float o_value;

const float kSpline[3] = float[](3.0 / 8.0, 1.0 / 4.0, 1.0 / 16.0);

void main() {
    ivec2 px = ivec2(v_uv * frameViewport.xy);
    float center = texelFetch(t_input, px, 0).r;
    float depth = gbufferDepthAt(v_uv);
    if (depth == 0.0) {
        o_value = center;
        return;
    }
    EdgeStops stops = edgeStopsAt(v_uv, depth, params.plane_tolerance, params.normal_power);

    // Eq. 5 with the weights of eq. 6: the spline times what the edge stops leave, over their sum.
    ivec2 last = ivec2(frameViewport.xy) - 1;
    float sum = kSpline[0] * kSpline[0] * center, total = kSpline[0] * kSpline[0];
    for (int y = -2; y <= 2; ++y)
        for (int x = -2; x <= 2; ++x) {
            ivec2 at = px + u_step * ivec2(x, y);
            if ((x == 0 && y == 0) || any(lessThan(at, ivec2(0))) || any(greaterThan(at, last))) continue;
            vec2 uv = (vec2(at) + 0.5) * frameViewport.zw;
            float depthThere = gbufferDepthAt(uv);
            if (depthThere == 0.0) continue;
            float value = texelFetch(t_input, at, 0).r, difference = value - center;
            float exponent = edgeStopExponent(stops, uv, depthThere) + u_perValue2 * difference * difference;
            float weight = kSpline[abs(x)] * kSpline[abs(y)] * exp2(exponent);
            sum += weight * value;
            total += weight;
        }
    o_value = sum / total;
}
