// SPDX-License-Identifier: MIT
// Adds up the cosines of directions in which some maps see the pixel's surface, and those of all directions above its tangent
// plane.
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"

layout(binding = 5) uniform sampler2DArray t_maps;   // reversed: 1 near, 0 far

uniform vec4 u_maps[5 * MAPS_PER_DRAW];   // to u, v and depth t (0 near, 1 far); direction to the light; S, bias and most slope in t
uniform int u_firstMap, u_mapCount;
uniform float u_resolution;

noperspective in vec2 v_uv;
noperspective in vec3 v_rayStart;
noperspective in vec3 v_rayAlong;

layout(location = 0) out vec2 o_sums;

void main() {
    uvec4 surface = gbufferSurfaceAt(v_uv);
    vec3 n_g = geometricNormalOf(surface), n_s = shadingNormalOf(surface);
    vec4 p = vec4(positionOnRay(v_rayStart, v_rayAlong, gbufferDepthAt(v_uv)), 1.0);

    float seen = 0.0, all = 0.0;
    for (int i = 0; i < u_mapCount; ++i) {
        vec3 l = u_maps[5 * i + 3].xyz;
        float cosine = dot(n_s, l), slope = dot(n_g, l);
        if (cosine <= 0.0) continue;
        all += cosine;
        // Below the geometric horizon the surface itself is in the way.
        if (slope <= 0.0) continue;

        vec4 toU = u_maps[5 * i], toV = u_maps[5 * i + 1], bounds = u_maps[5 * i + 4];
        vec2 uv = vec2(dot(toU, p), dot(toV, p));
        float t = dot(u_maps[5 * i + 2], p);
        // The texel holds what its centre sees: the receiver's tangent plane there is compared, not the receiver (Dou et al. 2014).
        vec2 aside = (floor(uv * u_resolution) + 0.5) / u_resolution - uv;
        float rise = dot(vec2(dot(n_g, toU.xyz), dot(n_g, toV.xyz)) * bounds.xy, aside) / slope;
        t += clamp(rise, -bounds.w, bounds.w) - bounds.z;
        if (1.0 - textureLod(t_maps, vec3(uv, float(u_firstMap + i)), 0.0).r >= t) seen += cosine;
    }
    o_sums = vec2(seen, all);
}
