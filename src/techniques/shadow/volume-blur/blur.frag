// SPDX-License-Identifier: MIT
// The hard shadow averaged over the light, or over a disk on the surface.
#include "shadow/volume-blur/penumbra.glsl"

layout(location = 0) out float o_visibility;

layout(binding = 5) uniform sampler2D t_hard;
layout(binding = 6) uniform usampler2D t_edges;

// i of n points in the unit disk, evenly (Vogel 1979), or in the square from -1 to 1 by the R2 sequence (Roberts 2018).
vec2 pointOfLight(int i, int n) {
    if (LIGHT_IS(LIGHT_RECT) && MODE == MODE_CONTACT)
        return 2.0 * fract(0.5 + vec2(0.7548776662467, 0.5698402909980) * float(i + 1)) - 1.0;
    float phi = 2.39996322972865 * float(i);
    return sqrt((float(i) + 0.5) / float(n)) * vec2(cos(phi), sin(phi));
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy), last = ivec2(frame.viewport.xy) - 1;
    o_visibility = texelFetch(t_hard, pixel, 0).r;
    uvec2 edge = texelFetch(t_edges, pixel, 0).xy;
    bool hasEdge = edge.x != kNoEdge;
#if MODE == MODE_CONTACT
    if (o_visibility == 0.0 && !hasEdge) return;
#else
    if (!hasEdge) return;
#endif
    float depth = gbufferDepth(pixel);
    vec3 p_world = positionOf(pixel, depth), n_g = gbufferGeometricNormal(pixel);
    float pixel_m = pixelSizeAt(viewDepthFromDepth(depth));
    float contact = unpackHalf2x16(edge.y).y;

    // The axes of the light's outline, or of the disk on the surface, times its half sizes.
    vec3 axisX, axisY;
    float distance_m;
    vec3 l = directionToLight(p_world, distance_m);
    float cosine = dot(n_g, l);
#if MODE == MODE_CONTACT
    if (abs(cosine) < 1e-3) return;
    bool isCut = abs(cosine) < 1.5 * lightRadius() / (LIGHT_IS(LIGHT_SUN) ? 1.0 : distance_m);
    if (!hasEdge && !isCut) return;
    if (LIGHT_IS(LIGHT_RECT)) {
        axisX = light.tangent.xyz * (light.tangent.w * params.size);
        axisY = light.bitangent.xyz * (light.bitangent.w * params.size);
    } else {
        if (LIGHT_IS(LIGHT_SPOT)) {
            axisX = light.tangent.xyz;
            axisY = light.bitangent.xyz;
        } else {
            basisOf(l, axisX, axisY);
        }
        axisX *= lightRadius();
        axisY *= lightRadius();
    }
#else
    basisOf(n_g, axisX, axisY);
    axisX *= constantRadius_m(pixel_m);
    axisY *= constantRadius_m(pixel_m);
#endif

    float sum = o_visibility, total = 1.0, farthest_m = params.reach * pixel_m;
    for (int i = 0; i < params.samples; ++i) {
        vec2 point = pointOfLight(i, params.samples);
        vec3 aside = axisX * point.x + axisY * point.y;
#if MODE == MODE_CONTACT
        // What lies below the receiver's horizon sends nothing.
        if (isCut && dot(n_g, LIGHT_IS(LIGHT_SUN) ? l + aside : l * distance_m + aside) <= 0.0) {
            total += 1.0;
            continue;
        }
        if (!hasEdge) {
            sum += o_visibility;
            total += 1.0;
            continue;
        }
        // A point of the light and the light's centre see the same point of the caster from two points of the receiver's
        // plane: whether this one sees the former is what the hard shadow says of the other.
        if (LIGHT_IS(LIGHT_SUN)) {
            aside = contact * (aside - l * (dot(n_g, aside) / cosine));
        } else {
            vec3 toPoint = contact * aside - (1.0 - contact) * distance_m * l;
            float along = dot(n_g, toPoint);
            if (along * cosine >= 0.0) continue;
            aside = l * distance_m + toPoint * (-distance_m * cosine / along);
        }
        float length_m = length(aside);
        if (length_m > farthest_m) aside *= farthest_m / length_m;
#endif
        // The hard shadow there, where the picture shows that surface.
        vec4 clip = frame.clipFromWorld * vec4(p_world + aside, 1.0);
        if (clip.w <= 0.0) continue;
        ivec2 at = ivec2(floor((clip.xy / clip.w * 0.5 + 0.5) * frame.viewport.xy));
        if (any(lessThan(at, ivec2(0))) || any(greaterThan(at, last))) continue;
        if (!isSameSurface(p_world, n_g, pixel_m, at, 0.1)) continue;
        sum += texelFetch(t_hard, at, 0).r;
        total += 1.0;
    }
    o_visibility = sum / total;
}
