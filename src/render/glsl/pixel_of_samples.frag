// SPDX-License-Identifier: MIT
// The G-buffer's pixel from its samples: one surface, continued to the pixel's centre, where techniques that know pixels alone look.
#include "ombrage/frame.glsl"
#include "ombrage/edge_samples.glsl"

noperspective in vec2 v_uv;
noperspective in vec3 v_rayStart;
noperspective in vec3 v_rayAlong;
layout(location = 0) out uvec4 o_surface;
layout(location = 1) out uint o_several;
#ifdef SAMPLE_MATERIALS
layout(location = 2) out uint o_material;
#endif

// Reversed-Z depth of a view distance.
float depthFromViewDepth(float distance_m) {
    if (isOrthographic()) return (frameProjection.y - distance_m) / (frameProjection.y - frameProjection.x);
    return frameProjection.x / distance_m;
}

// A depth that no other drawing of the surface at the centre exceeds, however it rounds: shadow volumes must not lie before the surface
// that they begin at. `change` is that over half a pixel or more; a 1000th of a pixel's way over the surface is no more than that.
float beforeRounding(float depth, float change) { return min(depth + depth * 4.8e-7 + change * 0.001, 1.0); }

// Where the plane of a sample's triangle meets the ray through the pixel's centre.
float depthAtCentre(uvec4 surface, float depth, vec2 offset_px) {
    vec3 n_g = geometricDirectionOf(surface);
    vec3 p_world = positionOn(rayBeside(v_rayStart, v_rayAlong, offset_px), depth);
    float distance_m = viewDepthFromDepth(depth);
    float atCentre_m = dot(n_g, p_world - v_rayStart) / dot(n_g, v_rayAlong);
    // A surface seen so nearly from its edge that half a pixel halves or doubles the distance stays where it was met.
    bool isNear = atCentre_m > 0.5 * distance_m && atCentre_m < 2.0 * distance_m;
    float atCentre = isNear ? depthFromViewDepth(atCentre_m) : depth;
    return beforeRounding(atCentre, abs(atCentre - depth));
}

void main() {
    ivec2 px = ivec2(v_uv * frameViewport.xy);
    float depths[PIXEL_SAMPLES];
    uint triangles[PIXEL_SAMPLES];
    float sum = 0.0, largest = 0.0, smallest = 1.0;
    bool same = true;
    for (int s = 0; s < PIXEL_SAMPLES; ++s) {
        depths[s] = sampleDepth(px, s);
        triangles[s] = depths[s] > 0.0 ? sampleSurface(px, s).w : kSky;
        sum += depths[s];
        largest = max(largest, depths[s]);
        smallest = min(smallest, depths[s]);
        same = same && triangles[s] == triangles[0];
    }
    // The surface of the most samples, of equals the nearer one; the sky only where there is nothing else.
    int shown = 0, most = 0;
    float depth = 0.0;
    vec2 offset_px = kSamplePositions[0];
    for (int s = 0; s < PIXEL_SAMPLES; ++s) {
        int count = 0;
        for (int r = 0; r < PIXEL_SAMPLES; ++r) count += triangles[r] == triangles[s] ? 1 : 0;
        if (triangles[s] == kSky || count < most || (count == most && depths[s] <= depth)) continue;
        most = count;
        shown = s;
        depth = depths[s];
        offset_px = kSamplePositions[s];
    }
    uvec4 surface = sampleSurface(px, shown);
    o_surface = surface;
    o_several = same ? 0u : 1u;
#ifdef SAMPLE_MATERIALS
    o_material = sampleMaterial(px, shown);
#endif
#ifdef BALANCED_SAMPLES
    // Depth is linear over the picture: the mean of one triangle's samples is its centre's.
    float inside = beforeRounding(sum / float(PIXEL_SAMPLES), largest - smallest);
#else
    float inside = depthAtCentre(surface, depth, offset_px);
#endif
    gl_FragDepth = depth == 0.0 ? 0.0 : same ? inside : depthAtCentre(surface, depth, offset_px);
}
