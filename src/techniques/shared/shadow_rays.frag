// SPDX-License-Identifier: MIT
// Visibility of the bound light by rays. SOFT: rays to points spread over it, else one ray to its centre.
// SAME_MODEL: casters of the receiver's own model alone. PATTERN: 0 random, 1 Owen-scrambled Sobol, 2 one Sobol set
// rotated by interleaved gradient noise.
#include "ombrage/gbuffer.glsl"
#include "shared/gpu_bvh.glsl"
#include "shared/light_sampling.glsl"
#include "shared/sample_patterns.glsl"

#ifdef SOFT
uniform ivec2 u_sampleRange;  // this pass takes the samples from x up to y; passes add up
uniform int u_sampleCount;    // of all passes
#endif

layout(location = 0) out float o_visibility;

vec2 samplePoint(uint index, uint seed, vec2 px) {
#if PATTERN == 0
    return randomPoint(index, seed);
#elif PATTERN == 1
    return owenSobolPoint(index, seed);
#else
    return rotatedSobolPoint(index, frame.random.x, px);
#endif
}

bool isSeen(RayOrigin o, LightSample s) {
    // Parts below the geometric horizon and parts that turn their back count as blocked.
    if (!s.facing || dot(s.direction, o.n_g) <= 0.0) return false;
    return !occluded(o, s.direction, rayLengthTo(s.distance_m));
}

// Whether some part of the light may shine here: in range, inside of the cone, not below the horizon.
bool isAsked(RayOrigin o, LightSample centre) {
    if (!o.isReal || centre.distance_m > light.direction.w) return false;
#ifdef SOFT
    int type = int(light.color.w);
    // No part is farther from the centre than this (a sun: at distance 1).
    float reach_m = type == LIGHT_RECT ? light.tangent.w + light.bitangent.w : light.cone.z;
    float height = dot(centre.direction, o.n_g) * (type == LIGHT_SUN ? 1.0 : centre.distance_m);
    // Rounding asks rather than leaves a pixel lit whose last bit of light is on the horizon.
    if (height < -1.0001 * reach_m - 1e-5) return false;
    if (type == LIGHT_RECT) return centre.facing;
    if (type == LIGHT_SPOT) {
        // The disk's rim may still shine where its centre does not.
        vec3 fromLight = -centre.direction * centre.distance_m;
        float front = dot(fromLight, light.direction.xyz);
        float aside = max(0.0, length(fromLight - front * light.direction.xyz) - reach_m);
        return front > 0.0 && front >= light.cone.y * length(vec2(front, aside));
    }
    return true;
#else
    return reachesCentre(o.n_g, centre);
#endif
}

void main() {
    ivec2 px = ivec2(gl_FragCoord.xy);
    bool asked = false;
    o_visibility = 1.0;
    // Branches instead of an early discard: discarded pixels may run on, as llvmpipe's do.
    if (gbufferDepth(px) != 0.0) {
        RayOrigin o = rayOriginOfPixel(px, gbufferTriangle(px));
        LightSample centre = lightCentre(o.p_world);
        asked = isAsked(o, centre);
        if (asked) {
#ifdef SOFT
            uint seed = hashOf(hashOf(uint(px.x), uint(px.y)), frame.random.x);
            uint seen = 0u;
            for (int i = u_sampleRange.x; i < u_sampleRange.y; ++i)
                if (isSeen(o, sampleLight(o.p_world, samplePoint(uint(i), seed, gl_FragCoord.xy)))) ++seen;
            o_visibility = float(seen) / float(u_sampleCount);
#else
            o_visibility = isSeen(o, centre) ? 1.0 : 0.0;
#endif
        }
    }
    if (!asked) discard;
}
