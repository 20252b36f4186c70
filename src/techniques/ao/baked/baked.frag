// SPDX-License-Identifier: MIT
// Looks the baked visibility up in the block of the pixel's triangle, on the side seen.
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"

layout(binding = 5) uniform sampler2D t_baked;
// Three corners of each triangle in the order of its block; w: across and up, front's place, back's place, as 16 bits each.
layout(std430, binding = 3) readonly buffer BakedBlocks { uvec4 b_blocks[]; };

uniform vec2 u_perTexel;

noperspective in vec2 v_uv;
noperspective in vec3 v_rayStart;
noperspective in vec3 v_rayAlong;

layout(location = 0) out float o_visibility;

void main() {
    o_visibility = 1.0;
    float depth = gbufferDepthAt(v_uv);
    if (depth == 0.0) return;
    uvec4 surface = gbufferSurfaceAt(v_uv);
    vec3 p = positionOnRay(v_rayStart, v_rayAlong, depth);
    uvec4 first = b_blocks[3u * surface.w], second = b_blocks[3u * surface.w + 1u], third = b_blocks[3u * surface.w + 2u];
    vec3 a = uintBitsToFloat(first.xyz), b = uintBitsToFloat(second.xyz), c = uintBitsToFloat(third.xyz);

    // Weights of the second and third corner.
    vec3 n = cross(b - a, c - a);
    float perArea = dot(n, n) > 0.0 ? 1.0 / dot(n, n) : 0.0;
    float w1 = dot(n, cross(a - c, p - c)) * perArea, w2 = clamp(dot(n, cross(b - a, p - a)) * perArea, 0.0, 1.0);

    // Rows run along the first edge and shrink to a point at the third corner.
    vec2 intervals = vec2(float(first.w & 0xffffu), float(first.w >> 16));
    vec2 at = vec2(w2 < 1.0 ? clamp(w1 / (1.0 - w2), 0.0, 1.0) : 0.0, w2) * intervals;
    uint place = dot(n, geometricDirectionOf(surface)) >= 0.0 ? second.w : third.w;
    vec2 corner = vec2(float(place & 0xffffu), float(place >> 16)) + 0.5;
    o_visibility = texture(t_baked, (corner + at) * u_perTexel).r;
}
