// SPDX-License-Identifier: MIT
// A mean over frames by reverse reprojection (Nehab et al. 2007), clamped to the variance of the neighbourhood (Salvi 2016).
#include "filter/temporal/params"
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"
#include "ombrage/reprojection.glsl"

layout(binding = 5) uniform sampler2D t_input;
layout(binding = 6) uniform sampler2D t_history;   // value, number of frames, distance along the view axis (0: sky)
uniform mat4 u_viewBefore;
uniform int u_hasHistory;

noperspective in vec2 v_uv;
layout(location = 0) out float o_value;
layout(location = 1) out vec4 o_history;

// Value and number of frames of what the frame before saw at a point of its picture, at that distance; 0 frames: nothing of it.
vec2 historyAt(vec2 uv, float distance_m) {
    vec2 at = uv * frameViewport.xy - 0.5, f = fract(at);
    ivec2 base = ivec2(floor(at)), last = ivec2(frameViewport.xy) - 1;
    vec2 sum = vec2(0.0);
    float total = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 corner = ivec2(i & 1, i >> 1), px = base + corner;
        float weight = (corner.x == 1 ? f.x : 1.0 - f.x) * (corner.y == 1 ? f.y : 1.0 - f.y);
        if (weight == 0.0 || any(lessThan(px, ivec2(0))) || any(greaterThan(px, last))) continue;
        vec4 past = texelFetch(t_history, px, 0);
        if (past.z == 0.0 || abs(past.z - distance_m) > params.depth_tolerance * distance_m) continue;
        sum += weight * past.xy;
        total += weight;
    }
    return total > 0.0 ? sum / total : vec2(0.0);
}

void main() {
    ivec2 px = ivec2(v_uv * frameViewport.xy), last = ivec2(frameViewport.xy) - 1;
    float current = texelFetch(t_input, px, 0).r;
    float depth = gbufferDepthAt(v_uv);
    o_value = current;
    o_history = vec4(current, 1.0, 0.0, 0.0);
    if (depth == 0.0) return;
    vec4 p_world = worldOf(v_uv, depth);
    float wBefore;
    vec2 uvBefore = v_uv - motionOf(p_world, wBefore);
    float distanceBefore_m = -(u_viewBefore * p_world).z;
    o_history.z = viewDepthFromDepth(depth);
    if (u_hasHistory == 0 || wBefore <= 0.0) return;
    vec2 history = historyAt(uvBefore, distanceBefore_m);
    if (history.y == 0.0) return;

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
    float value = mix(past, current, max(params.blend, 1.0 / (history.y + 1.0)));
    o_value = value;
    o_history.xy = vec2(value, min(history.y + 1.0, 65536.0));
}
