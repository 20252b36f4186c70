// SPDX-License-Identifier: MIT
// Visibility of the bound light by rays. SOFT: rays to points spread over it, else one ray to its centre.
// PATTERN: 0 random, 1 Owen-scrambled Sobol, 2 one Sobol set rotated by interleaved gradient noise.
#include "ombrage/gbuffer.glsl"
#include "shadow/ray-traced/params"
#include "shared/gpu_bvh.glsl"
#include "shared/light_sampling.glsl"
#include "shared/sample_patterns.glsl"

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

void main() {
    ivec2 px = ivec2(gl_FragCoord.xy);
    uint triangle = gbufferIds(px).y;
    if (triangle == ~0u) discard;
    RayOrigin o = rayOriginOfPixel(px, triangle);

    // Where no part of the light can shine nothing is asked: out of range, outside the cone, below the horizon.
    LightSample centre = lightCentre(o.p_world);
    if (centre.distance_m > light.direction.w) discard;
    int type = int(light.color.w);
#ifdef SOFT
    float reach_m = type == LIGHT_SUN ? light.cone.z : type == LIGHT_RECT ? light.tangent.w + light.bitangent.w : light.cone.z;
    float height = dot(centre.direction, o.n_g) * (type == LIGHT_SUN ? 1.0 : centre.distance_m);
    if (height + reach_m <= 0.0 || (type == LIGHT_RECT && !centre.facing)) discard;
    if (type == LIGHT_SPOT) {
        // The disk's rim may still shine where its centre does not.
        vec3 fromLight = -centre.direction * centre.distance_m;
        float front = dot(fromLight, light.direction.xyz);
        float aside = max(0.0, length(fromLight - front * light.direction.xyz) - reach_m);
        if (front <= 0.0 || front < light.cone.y * length(vec2(front, aside))) discard;
    }
    uint seed = hashOf(hashOf(uint(px.x), uint(px.y)), frame.random.x);
    uint count = uint(params.samples), seen = 0u;
    for (uint i = 0u; i < count; ++i)
        if (isSeen(o, sampleLight(o.p_world, samplePoint(i, seed, gl_FragCoord.xy)))) ++seen;
    o_visibility = float(seen) / float(count);
#else
    if (dot(centre.direction, o.n_g) <= 0.0 || !centre.facing) discard;
    if (type == LIGHT_SPOT && dot(-centre.direction, light.direction.xyz) < light.cone.y) discard;
    o_visibility = isSeen(o, centre) ? 1.0 : 0.0;
#endif
}
