// SPDX-License-Identifier: MIT
// Which of the pixels of several triangles show several surfaces, and from which pixel each of their samples takes what is known of pixels alone: visibility,
// occlusion, indirect light.
#include "ombrage/frame.glsl"
#include "ombrage/edge_samples.glsl"
#include "ombrage/instances.glsl"

noperspective in vec2 v_uv;
noperspective in vec3 v_rayStart;
noperspective in vec3 v_rayAlong;
layout(location = 0) out uint o_edges;

// Other triangles of one instance are one surface where lighting could hardly tell them apart: less than this between the normals of
// the triangles, between those they are shaded with, in the roots of their colours, and a pixel in depth.
const float kLikeFacets = 0.966;    // 15 degrees: facets of a finely tessellated ball
const float kLikeNormals = 0.9994;  // 2 degrees
const float kLikeColors = 1.0 / 64.0;

vec3 rootsOf(uint albedo) {
    return vec3(albedo & 2047u, (albedo >> 11) & 2047u, albedo >> 22) * (1.0 / vec3(2047.0, 2047.0, 1023.0));
}

// Distance of a sample from the plane that a pixel shows, in pixels.
float stepBetween(vec3 p_world, uvec4 pixel, vec3 p_pixel, float depth) {
    return abs(dot(geometricNormalOf(pixel), p_world - p_pixel)) / pixelSizeAt(viewDepthFromDepth(depth));
}

bool isAlike(uvec4 surface, uint material, vec3 p_world, float depth, uvec4 pixel, uint pixelMaterial, vec3 p_pixel) {
    vec3 colors = abs(rootsOf(surface.z) - rootsOf(pixel.z));
    return b_triangles[surface.w] == b_triangles[pixel.w] && material == pixelMaterial && max(colors.r, max(colors.g, colors.b)) < kLikeColors &&
           dot(geometricNormalOf(surface), geometricNormalOf(pixel)) > kLikeFacets &&
           dot(shadingNormalOf(surface), shadingNormalOf(pixel)) > kLikeNormals && stepBetween(p_world, pixel, p_pixel, depth) < 1.0;
}

// The pixel of the 3x3 that shows the sample's triangle, the nearest such; else the one whose plane the sample is nearest to.
uint pixelLike(ivec2 px, uvec4 surface, vec3 p_world, float depth, vec2 offset_px) {
    uint best = 4u;
    float least = 1e30;
    for (int i = 0; i < 9; ++i) {
        ivec2 beside = ivec2(i % 3 - 1, i / 3 - 1), at = px + beside;
        if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, ivec2(frameViewport.xy)))) continue;
        float atDepth = gbufferDepth(at);
        if (atDepth == 0.0) continue;
        uvec4 pixel = gbufferSurface(at);
        vec2 way_px = vec2(beside) - offset_px;
        float unlike = 0.05 * dot(way_px, way_px);
        if (pixel.w != surface.w) {
            vec3 p_pixel = positionOn(rayBeside(v_rayStart, v_rayAlong, vec2(beside)), atDepth);
            unlike += 1.0 + stepBetween(p_world, pixel, p_pixel, depth) +
                      4.0 * (1.0 - dot(geometricNormalOf(surface), geometricNormalOf(pixel)));
        }
        if (unlike < least) {
            least = unlike;
            best = uint(i);
        }
    }
    return best;
}

void main() {
    ivec2 px = ivec2(v_uv * frameViewport.xy);
    float pixelDepth = gbufferDepth(px);
    uvec4 pixel = gbufferSurface(px);
    vec3 p_pixel = positionOnRay(v_rayStart, v_rayAlong, pixelDepth);
    uint bits = 0u, pixelMaterial = 0u;
#ifdef SAMPLE_MATERIALS
    pixelMaterial = texelFetch(t_material, px, 0).r;
#endif
    bool differs = false;
    for (int s = 0; s < PIXEL_SAMPLES; ++s) {
        float depth = sampleDepth(px, s);
        uvec4 surface = sampleSurface(px, s);
        uint source = 4u;
        if (depth == 0.0) {
            differs = true;
        } else if (surface.w != pixel.w) {
            vec3 p_world = positionOn(rayBeside(v_rayStart, v_rayAlong, kSamplePositions[s]), depth);
            differs = differs || !isAlike(surface, sampleMaterial(px, s), p_world, depth, pixel, pixelMaterial, p_pixel);
            source = pixelLike(px, surface, p_world, depth, kSamplePositions[s]);
        }
        bits |= (source + 1u) << (4 * s);
    }
    o_edges = differs ? bits : 0u;
}
