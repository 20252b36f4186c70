// SPDX-License-Identifier: MIT
// The naive ways of composing. ACCUMULATE: adds or multiplies one light's share of shadow; else: applies the factor, with PIXEL_SAMPLES
// to each sample of the pixels that show several surfaces, by blending. COLORED: what is read has red, green and blue.
#include "ombrage/frame.glsl"
#ifdef PIXEL_SAMPLES
#include "ombrage/edge_samples.glsl"
#else
#include "ombrage/gbuffer.glsl"
#endif

layout(binding = 5) uniform sampler2D t_visibility;
layout(binding = 6) uniform sampler2D t_color;
layout(binding = 7) uniform sampler2D t_factor;

#ifdef COLORED
#define CHANNELS rgb
#else
#define CHANNELS rrr
#endif

uniform float u_scale;   // overlay: opacity / number of lights

#ifdef PIXEL_SAMPLES
layout(location = 0) out vec4 o_samples[PIXEL_SAMPLES];

void main() {
    ivec2 px = ivec2(gl_FragCoord.xy);
    uint bits = edgeBits(px);
    if (bits == 0u) discard;
    for (int s = 0; s < PIXEL_SAMPLES; ++s) {
        vec3 factor = texelFetch(t_factor, pixelOfSample(px, bits, s), 0).CHANNELS;
        if (sampleDepth(px, s) == 0.0) factor = vec3(1.0);
        else if (COMPOSITE != 1) factor = max(1.0 - factor, vec3(0.0));
        o_samples[s] = vec4(factor, 1.0);
    }
}
#else
layout(location = 0) out vec4 o_color;

void main() {
    ivec2 px = ivec2(gl_FragCoord.xy);
    bool sky = gbufferDepth(px) == 0.0;
#if defined(ACCUMULATE)
    vec3 seen = sky ? vec3(1.0) : texelFetch(t_visibility, px, 0).CHANNELS;
#if COMPOSITE == 1
    o_color = vec4(seen, 1.0);
#else
    o_color = vec4((1.0 - seen) * u_scale, 1.0);
#endif
#else
    vec3 color = texelFetch(t_color, px, 0).rgb;
    vec3 factor = texelFetch(t_factor, px, 0).CHANNELS;
#if COMPOSITE == 1
    o_color = vec4(color * factor, 1.0);
#else
    o_color = vec4(color * max(1.0 - factor, vec3(0.0)), 1.0);
#endif
#endif
}
#endif
