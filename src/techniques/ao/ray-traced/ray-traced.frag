// SPDX-License-Identifier: MIT
// Counts of each pixel's rays those that meet nothing within the radius: cosine-weighted about the shading normal. PATTERN as in
// sampleAt().
#include "ombrage/gbuffer.glsl"
#include "shared/basis.glsl"
#include "shared/gpu_bvh.glsl"
#include "shared/sample_patterns.glsl"

uniform ivec2 u_sampleRange;   // this draw takes the samples from x up to y; draws add up
uniform float u_radius_m;
#if PATTERN == PATTERN_BLUE_NOISE
layout(binding = 5) uniform sampler2D t_blueNoise;   // [0,1), tiles
#endif

layout(location = 0) out float o_open;

#if PATTERN == PATTERN_BLUE_NOISE
// Two numbers of the tile, far from each other and moved by the seed.
vec2 blueNoiseOf(ivec2 px) {
    int last = textureSize(t_blueNoise, 0).x - 1;
    uint moved = hashOf(frame.random.x, 0x51ed270bu);
    ivec2 at = px + ivec2(int(moved & 0xffffu), int(moved >> 16));
    return vec2(texelFetch(t_blueNoise, at & last, 0).r, texelFetch(t_blueNoise, (at.yx + ivec2(23, 41)) & last, 0).r);
}
#endif

vec2 sampleAt(uint index, uint seed, ivec2 px) {
#if PATTERN == PATTERN_RANDOM
    return randomPoint(index, seed);
#elif PATTERN == PATTERN_SOBOL
    return owenSobolPoint(index, seed);
#elif PATTERN == PATTERN_ROTATED
    return rotatedSobolPoint(index, frame.random.x, vec2(px) + 0.5);
#else
    return fract(owenSobolPoint(index, frame.random.x) + blueNoiseOf(px));
#endif
}

void main() {
    ivec2 px = ivec2(gl_FragCoord.xy);
    o_open = 0.0;
    // Pixels of the sky may run on beside their neighbours.
    if (gbufferDepth(px) == 0.0) return;
    uvec4 surface = gbufferSurface(px);
    RayOrigin o = rayOriginOfPixel(px, surface.w);
    vec3 n = shadingNormalOf(surface), t, b;
    basisOf(n, t, b);

    uint seed = hashOf(hashOf(uint(px.x), uint(px.y)), frame.random.x);
    uint open = 0u;
    for (int i = u_sampleRange.x; i < u_sampleRange.y; ++i) {
        // A point of the unit disk lifted to the sphere is cosine-weighted (Malley's method).
        vec2 u = sampleAt(uint(i), seed, px);
        float phi = 6.28318530717959 * u.y;
        vec3 d = (t * cos(phi) + b * sin(phi)) * sqrt(u.x) + n * sqrt(1.0 - u.x);
        // Below the geometric horizon the surface itself is in the way.
        if (dot(d, o.n_g) > 0.0 && !occluded(o, d, u_radius_m)) ++open;
    }
    o_open = float(open);
}
