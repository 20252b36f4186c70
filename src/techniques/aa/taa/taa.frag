// SPDX-License-Identifier: MIT
// Temporal anti-aliasing (Karis 2014) with variance clipping (Salvi 2016).
#include "aa/taa/params"
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"
#include "ombrage/reprojection.glsl"

layout(binding = 5) uniform sampler2D t_picture;
layout(binding = 6) uniform sampler2D t_history;   // filtered linearly; in alpha the number of frames in it
uniform int u_hasHistory;

noperspective in vec2 v_uv;
layout(location = 0) out vec4 o_color;
layout(location = 1) out vec4 o_history;

float lumaOf(vec3 color) { return dot(color, vec3(0.2126, 0.7152, 0.0722)); }

// The space in which colours are averaged.
#if LUMA_WEIGHTS
vec3 weighted(vec3 color) { return color / (1.0 + lumaOf(color)); }
vec3 unweighted(vec3 color) { return color / max(1.0 - lumaOf(color), 1e-3); }
#else
vec3 weighted(vec3 color) { return color; }
vec3 unweighted(vec3 color) { return color; }
#endif

vec3 yCoCgOf(vec3 c) { return vec3(0.25 * c.r + 0.5 * c.g + 0.25 * c.b, 0.5 * c.r - 0.5 * c.b, -0.25 * c.r + 0.5 * c.g - 0.25 * c.b); }
vec3 rgbOf(vec3 c) { return vec3(c.x + c.y - c.z, c.x + c.z, c.x - c.y - c.z); }

vec4 historyAt(vec2 uv) {
#if HISTORY_FILTER == HISTORY_FILTER_CATMULL_ROM
    // Catmull-Rom over 4x4 texels by nine linear fetches: the two middle ones of each axis in one.
    vec2 size = frameViewport.xy;
    vec2 at = uv * size - 0.5, f = fract(at), base = floor(at) + 0.5;
    vec2 w0 = f * (-0.5 + f * (1.0 - 0.5 * f)), w1 = 1.0 + f * f * (-2.5 + 1.5 * f);
    vec2 w2 = f * (0.5 + f * (2.0 - 1.5 * f)), w3 = f * f * (-0.5 + 0.5 * f);
    vec2 w12 = w1 + w2;
    vec2 x[3] = vec2[](base - 1.0, base + w2 / w12, base + 2.0);
    vec2 w[3] = vec2[](w0, w12, w3);
    vec3 sum = vec3(0.0);
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i)
            sum += w[i].x * w[j].y * textureLod(t_history, vec2(x[i].x, x[j].y) * frameViewport.zw, 0.0).rgb;
    return vec4(max(sum, vec3(0.0)), textureLod(t_history, uv, 0.0).a);
#else
    return textureLod(t_history, uv, 0.0);
#endif
}

void main() {
    ivec2 px = ivec2(v_uv * frameViewport.xy), last = ivec2(frameViewport.xy) - 1;
    vec4 shown = texelFetch(t_picture, px, 0);
    vec3 current = yCoCgOf(weighted(shown.rgb));

    // Mean and standard deviation of the 3x3 neighbourhood, and the nearest surface in it: its motion is that of the outline.
    vec3 sum = vec3(0.0), sum2 = vec3(0.0);
    float nearest = -1.0;
    vec2 nearestUv = v_uv;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            ivec2 at = clamp(px + ivec2(x, y), ivec2(0), last);
            vec3 c = yCoCgOf(weighted(texelFetch(t_picture, at, 0).rgb));
            sum += c;
            sum2 += c * c;
            vec2 uv = (vec2(at) + 0.5) * frameViewport.zw;
            float depth = gbufferDepthAt(uv);
            if (depth > nearest) {
                nearest = depth;
                nearestUv = uv;
            }
        }
    vec3 mean = sum / 9.0, deviation = sqrt(max(sum2 / 9.0 - mean * mean, vec3(0.0)));

    float wBefore;
    vec2 uvBefore = v_uv - motionOf(worldOf(nearestUv, nearest), wBefore);
    float count = 0.0;
    vec3 mixed = current;
    if (u_hasHistory != 0 && wBefore > 0.0 && all(greaterThanEqual(uvBefore, vec2(0.0))) && all(lessThanEqual(uvBefore, vec2(1.0)))) {
        vec4 history = historyAt(uvBefore);
        vec3 past = yCoCgOf(weighted(history.rgb));
        // Variance clipping: from outside of the box of gamma deviations, towards its middle onto its face.
        vec3 away = past - mean;
        vec3 over = abs(away) / max(params.gamma * deviation, vec3(1e-5));
        past = mean + away / max(1.0, max(over.x, max(over.y, over.z)));
        // A mean of all frames, until it is as long as the blend asks for.
        count = history.a;
        mixed = mix(past, current, max(params.blend, 1.0 / (count + 1.0)));
    }
    vec3 color = max(unweighted(rgbOf(mixed)), vec3(0.0));
    o_color = vec4(color, shown.a);
    o_history = vec4(color, min(count + 1.0, 1024.0));
}
