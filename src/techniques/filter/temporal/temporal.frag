// SPDX-License-Identifier: MIT
// A mean over frames by reverse reprojection (Nehab et al. 2007), clamped to the variance of the neighbourhood (Salvi 2016).
#include "filter/temporal/params"
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"
#include "shared/history.glsl"

layout(binding = 5) uniform sampler2D t_input;
layout(binding = 6) uniform sampler2D t_history;   // value, nothing, distance along the view axis (0: sky), number of frames

noperspective in vec2 v_uv;
layout(location = 0) out float o_value;
layout(location = 1) out vec4 o_history;

void main() {
    ivec2 px = ivec2(v_uv * frameViewport.xy), last = ivec2(frameViewport.xy) - 1;
    float current = texelFetch(t_input, px, 0).r;
    float depth = gbufferDepthAt(v_uv);
    o_value = current;
    o_history = vec4(current, 0.0, 0.0, 1.0);
    if (depth == 0.0) return;
    o_history.z = viewDepthFromDepth(depth);
    HistoryTaps taps;
    vec4 history;
    if (!findHistory(t_history, v_uv, depth, params.depth_tolerance, taps, history)) return;

    // Mean and standard deviation of the 3x3 neighbourhood.
    float sum = 0.0, sum2 = 0.0;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            float v = texelFetch(t_input, clamp(px + ivec2(x, y), ivec2(0), last), 0).r;
            sum += v;
            sum2 += v * v;
        }
    float mean = sum / 9.0, reach = params.gamma * sqrt(max(sum2 / 9.0 - mean * mean, 0.0));
    float past = clamp(history.x, mean - reach, mean + reach);

    // A mean of all frames, until it is as long as the blend asks for.
    float value = mix(past, current, max(params.blend, 1.0 / (history.w + 1.0)));
    o_value = value;
    o_history.x = value;
    o_history.w = min(history.w + 1.0, 65536.0);
}
