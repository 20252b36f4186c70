// SPDX-License-Identifier: MIT
// The mean of the samples, where a pixel shows several surfaces.
#include "aa/msaa/params"
#include "ombrage/frame.glsl"
#include "ombrage/edge_samples.glsl"

layout(binding = 5) uniform sampler2DArray t_edgeColors;   // a layer for each sample

layout(location = 0) out vec4 o_color;
#ifdef WRITE_SURFACES
layout(location = 1) out float o_others;
#endif

float weightOf(vec3 color) {
#if LUMA_WEIGHTS
    return 1.0 / (1.0 + dot(color, vec3(0.2126, 0.7152, 0.0722)));
#else
    return 1.0;
#endif
}

void main() {
    ivec2 px = ivec2(gl_FragCoord.xy);
    if (edgeBits(px) == 0u) discard;
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (int s = 0; s < PIXEL_SAMPLES; ++s) {
        vec3 color = texelFetch(t_edgeColors, ivec3(px, s), 0).rgb;
        float weight = weightOf(color);
        sum += weight * color;
        weights += weight;
    }
    o_color = vec4(sum / weights, 1.0);
#ifdef WRITE_SURFACES
    o_others = 0.0;
    for (int s = 1; s < PIXEL_SAMPLES; ++s) {
        bool isSky = sampleDepth(px, s) == 0.0, firstIsSky = sampleDepth(px, 0) == 0.0;
        bool isOther = isSky != firstIsSky || (!isSky && sampleSurface(px, s).w != sampleSurface(px, 0).w);
        o_others += isOther ? 1.0 / float(PIXEL_SAMPLES) : 0.0;
    }
#endif
}
