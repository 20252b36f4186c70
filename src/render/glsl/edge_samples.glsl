// SPDX-License-Identifier: MIT
// The samples that a multisampled G-buffer is made of (render/edge_samples.h): PIXEL_SAMPLES a pixel, at PIXEL_SAMPLE_POSITIONS in pixels from
// its centre. SAMPLE_MATERIALS: with the material's word. Needs ombrage/frame.glsl.
#include "ombrage/gbuffer.glsl"

layout(binding = 8) uniform sampler2DMS t_sampleDepth;
layout(binding = 9) uniform usampler2DMS t_sampleSurface;
layout(binding = 10) uniform usampler2DMS t_sampleMaterial;
layout(binding = 11) uniform usampler2D t_edges;

const uint kSky = 0xffffffffu;   // in the place of a triangle
const vec2 kSamplePositions[PIXEL_SAMPLES] = PIXEL_SAMPLE_POSITIONS;

float sampleDepth(ivec2 px, int s) { return texelFetch(t_sampleDepth, px, s).r; }
uvec4 sampleSurface(ivec2 px, int s) { return texelFetch(t_sampleSurface, px, s); }
uint sampleMaterial(ivec2 px, int s) {
#ifdef SAMPLE_MATERIALS
    return texelFetch(t_sampleMaterial, px, s).r;
#else
    return 0u;
#endif
}

// 0 where all samples of the pixel show one surface. Else four bits a sample: 1 + the number, row by row, of the pixel in the 3x3
// around it that shows the sample's surface, 5 itself.
uint edgeBits(ivec2 px) { return texelFetch(t_edges, px, 0).r; }
ivec2 pixelOfSample(ivec2 px, uint bits, int s) {
    int number = int(bits >> (4 * s) & 15u) - 1;
    return px + ivec2(number % 3 - 1, number / 3 - 1);
}

// What the pixel's ray (ombrage/fullscreen.vert) hits at a point of the picture beside its centre, at a distance along the view axis.
struct Ray { vec3 start, along; };
Ray rayBeside(vec3 rayStart, vec3 rayAlong, vec2 offset_px) {
    vec2 plane = 2.0 * offset_px * frameViewport.zw * frameProjection.zw;
    vec3 aside = frame.worldFromView[0].xyz * plane.x + frame.worldFromView[1].xyz * plane.y;
    return isOrthographic() ? Ray(rayStart + aside, rayAlong) : Ray(rayStart, rayAlong + aside);
}
vec3 positionOn(Ray ray, float depth) { return positionOnRay(ray.start, ray.along, depth); }
