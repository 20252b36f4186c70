// SPDX-License-Identifier: MIT
// Section 4.2 of Schied et al. 2017: the variance of a frame's values, over frames or, where there are few, over 7x7 pixels.
#include "filter/svgf/params"
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"
#include "shared/edge_stops.glsl"

layout(binding = 5) uniform sampler2D t_accumulated;
layout(binding = 6) uniform sampler2D t_moments;   // first and second, distance along the view axis, number of frames

noperspective in vec2 v_uv;
layout(location = 0) out vec2 o_level;   // value and variance

const float kFramesToTrust = 4.0;

// Both moments over the surface around the pixel.
vec2 momentsAround(ivec2 px, vec2 moments, float depth) {
    EdgeStops stops = edgeStopsAt(v_uv, depth, params.sigma_z, params.sigma_n);
    ivec2 last = ivec2(frameViewport.xy) - 1;
    vec2 sum = moments;
    float total = 1.0;
    for (int y = -3; y <= 3; ++y)
        for (int x = -3; x <= 3; ++x) {
            ivec2 at = px + ivec2(x, y);
            if ((x == 0 && y == 0) || any(lessThan(at, ivec2(0))) || any(greaterThan(at, last))) continue;
            vec2 uv = (vec2(at) + 0.5) * frameViewport.zw;
            float depthThere = gbufferDepthAt(uv);
            if (depthThere == 0.0) continue;
            float weight = exp2(edgeStopExponent(stops, uv, depthThere));
            sum += weight * texelFetch(t_moments, at, 0).xy;
            total += weight;
        }
    return sum / total;
}

void main() {
    ivec2 px = ivec2(v_uv * frameViewport.xy);
    vec4 gathered = texelFetch(t_moments, px, 0);
    vec2 moments = gathered.xy;
    float depth = gbufferDepthAt(v_uv);
    if (depth != 0.0 && gathered.w < kFramesToTrust) moments = momentsAround(px, moments, depth);
    float variance = max(moments.y - moments.x * moments.x, 0.0);
#if GUIDE == GUIDE_MEAN
    // Of a plain mean, then of one that forgets.
    variance *= max(1.0 / gathered.w, params.alpha / (2.0 - params.alpha));
#endif
    o_level = vec2(texelFetch(t_accumulated, px, 0).r, variance);
}
