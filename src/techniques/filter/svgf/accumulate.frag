// SPDX-License-Identifier: MIT
// Sections 4.1 and 4.2 of Schied et al. 2017: values and their first two moments, blended into those of the frame before.
#include "filter/svgf/params"
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"
#include "shared/history.glsl"

layout(binding = 5) uniform sampler2D t_input;
layout(binding = 6) uniform sampler2D t_moments;   // first and second, distance along the view axis (0: sky), number of frames
layout(binding = 7) uniform sampler2D t_values;    // what the frame before kept, in r

noperspective in vec2 v_uv;
layout(location = 0) out float o_value;
layout(location = 1) out vec4 o_moments;

void main() {
    float current = texelFetch(t_input, ivec2(v_uv * frameViewport.xy), 0).r;
    vec2 moments = vec2(current, current * current);
    float depth = gbufferDepthAt(v_uv);
    o_value = current;
    o_moments = vec4(moments, 0.0, 1.0);
    if (depth == 0.0) return;
    o_moments.z = viewDepthFromDepth(depth);
    // The paper also compares normals and meshes, and asks 3x3 pixels where none of the four fits.
    HistoryTaps taps;
    vec4 past;
    if (!findHistory(t_moments, v_uv, depth, params.depth_tolerance, taps, past)) return;

    // Means of all frames, until they are as long as the blends ask for.
    float frames = min(past.w + 1.0, 65536.0);
    o_value = mix(historyOf(t_values, taps).r, current, max(params.alpha, 1.0 / frames));
    o_moments.xy = mix(past.xy, moments, max(params.moments_alpha, 1.0 / frames));
    o_moments.w = frames;
}
