// SPDX-License-Identifier: MIT
// Sizes of penumbrae.
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"
#include "shadow/volume-blur/params"
#include "shared/light_sampling.glsl"

// Edges that reach a pixel: x the pixel of the edge (x and y of 16 bits), y its radius in pixels and its contact distance (2
// half floats). No edge: kNoEdge.
const uint kNoEdge = 0xffffffffu;

// Tangent of the angle between surface and light below which a penumbra is not stretched any longer.
const float kSteepest = 0.2;

// Edges are handed on a little farther than they reach, for those that come round another.
const float kFarther = 1.5;

// Of the light, in metres; for a sun the tangent of half its angle.
float lightRadius() {
    if (LIGHT_IS(LIGHT_RECT)) return params.size * length(vec2(light.tangent.w, light.bitangent.w));
    return params.size * light.cone.z;
}

// Largest half width of the penumbra on the surface: light size times the distance from caster to receiver over that from
// light to caster (Fernando 2005, "Percentage-closer soft shadows"), longer where light grazes.
float penumbraRadius_m(vec3 p_world, vec3 n_g, float contact) {
    float distance_m;
    vec3 l = directionToLight(p_world, distance_m);
    float scale = LIGHT_IS(LIGHT_SUN) ? contact : contact / max(1.0 - contact, 1e-3);
    return lightRadius() * scale / max(abs(dot(n_g, l)), kSteepest);
}

float constantRadius_m(float pixel_m) {
    return 0.5 * params.width * (UNIT == UNIT_PIXELS ? pixel_m : 1.0);
}

vec3 positionInView(ivec2 pixel, float depth) {
    return positionViewFromDepth((vec2(pixel) + 0.5) * frame.viewport.zw, depth);
}

vec3 positionOf(ivec2 pixel, float depth) {
    return (frame.worldFromView * vec4(positionInView(pixel, depth), 1.0)).xyz;
}

// Whether a pixel shows the surface that p_world with normal n_g and pixels of size pixel_m lies on; `rise` is how far it
// may leave the tangent plane, per metre from p_world.
bool isSameSurface(vec3 p_world, vec3 n_g, float pixel_m, ivec2 at, float rise) {
    float depth = gbufferDepth(at);
    if (depth == 0.0) return false;
    vec3 aside = positionOf(at, depth) - p_world;
    if (abs(dot(n_g, aside)) > params.plane_tolerance * pixel_m + rise * length(aside)) return false;
    return dot(n_g, gbufferGeometricNormal(at)) >= params.normal_tolerance;
}

// Distance of a pixel from an edge, in that edge's radii.
float edgeReach(uvec2 edge, ivec2 pixel) {
    return distance(vec2(edge.x & 0xffffu, edge.x >> 16), vec2(pixel)) / max(unpackHalf2x16(edge.y).x, 0.5);
}
