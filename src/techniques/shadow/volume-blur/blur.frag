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

struct Receiver {
    ivec2 pixel;
    vec3 p_world, n_g, l;
    float pixel_m, distance_m, cosine;
};

// A point of the light and the light's centre see the same point of the caster from two points of the receiver's plane: whether
// the receiver sees the former is what the hard shadow says of the other. `aside` goes from the light's centre to its point,
// then from the receiver to the other point.
bool moveOnPlane(Receiver r, float contact, inout vec3 aside) {
    if (LIGHT_IS(LIGHT_SUN)) {
        aside = contact * (aside - r.l * (dot(r.n_g, aside) / r.cosine));
    } else {
        vec3 toPoint = contact * aside - (1.0 - contact) * r.distance_m * r.l;
        float along = dot(r.n_g, toPoint);
        if (along * r.cosine >= 0.0) return false;
        aside = r.l * r.distance_m + toPoint * (-r.distance_m * r.cosine / along);
    }
    float length_m = length(aside), farthest_m = params.reach * r.pixel_m;
    if (length_m > farthest_m) aside *= farthest_m / length_m;
    return true;
}

// The pixel that shows the receiver's surface there, if one does.
bool findPixel(Receiver r, vec3 aside, out ivec2 at) {
    vec4 clip = frame.clipFromWorld * vec4(r.p_world + aside, 1.0);
    at = ivec2(floor((clip.xy / clip.w * 0.5 + 0.5) * frame.viewport.xy));
    if (clip.w <= 0.0 || any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, ivec2(frame.viewport.xy)))) return false;
    return isSameSurface(r.p_world, r.n_g, r.pixel_m, at, 0.1);
}

float hardAt(ivec2 at) { return texelFetch(t_hard, at, 0).r; }

void main() {
    Receiver r;
    r.pixel = ivec2(gl_FragCoord.xy);
    o_visibility = hardAt(r.pixel);
    uvec2 edge = texelFetch(t_edges, r.pixel, 0).xy;
    bool hasEdge = edge.x != kNoEdge && edgeReach(edge, r.pixel) < kFarther;
#if MODE == MODE_CONTACT
    if (o_visibility == 0.0 && !hasEdge) return;
#else
    if (!hasEdge) return;
#endif
    float depth = gbufferDepth(r.pixel);
    r.p_world = positionOf(r.pixel, depth);
    r.n_g = gbufferGeometricNormal(r.pixel);
    r.pixel_m = pixelSizeAt(viewDepthFromDepth(depth));
    r.l = directionToLight(r.p_world, r.distance_m);
    r.cosine = dot(r.n_g, r.l);
    float contact = unpackHalf2x16(edge.y).y;

    // The axes of the light's outline, or of the disk on the surface, times its half sizes.
    vec3 axisX, axisY;
#if MODE == MODE_CONTACT
    if (abs(r.cosine) < 1e-3) return;
    bool isCut = abs(r.cosine) < 1.5 * lightRadius() / (LIGHT_IS(LIGHT_SUN) ? 1.0 : r.distance_m);
    if (!hasEdge && !isCut) return;
    if (LIGHT_IS(LIGHT_RECT)) {
        axisX = light.tangent.xyz * (light.tangent.w * params.size);
        axisY = light.bitangent.xyz * (light.bitangent.w * params.size);
    } else {
        if (LIGHT_IS(LIGHT_SPOT)) {
            axisX = light.tangent.xyz;
            axisY = light.bitangent.xyz;
        } else {
            basisOf(r.l, axisX, axisY);
        }
        axisX *= lightRadius();
        axisY *= lightRadius();
    }
    vec3 toLight = r.l * (LIGHT_IS(LIGHT_SUN) ? 1.0 : r.distance_m);
#else
    basisOf(r.n_g, axisX, axisY);
    axisX *= constantRadius_m(r.pixel_m);
    axisY *= constantRadius_m(r.pixel_m);
#endif

    float sum = o_visibility, total = 1.0;
    for (int i = 0; i < params.samples; ++i) {
        vec2 point = pointOfLight(i, params.samples);
        vec3 aside = axisX * point.x + axisY * point.y;
        float hard = o_visibility;
#if MODE == MODE_CONTACT
        vec3 ofLight = aside;
        ivec2 at;
        if (isCut && dot(r.n_g, toLight + aside) <= 0.0) {
            // What lies below the receiver's horizon sends nothing.
            hard = 0.0;
        } else if (hasEdge) {
            if (!moveOnPlane(r, contact, aside) || !findPixel(r, aside, at)) continue;
            hard = hardAt(at);
            // Where another caster's shadow begins there, that one's distance is asked as well.
            uvec2 other = texelFetch(t_edges, at, 0).xy;
            float contactThere = unpackHalf2x16(other.y).y;
            if (hard == 0.0 && other.x != kNoEdge && contactThere < 0.8 * contact) {
                aside = ofLight;
                if (moveOnPlane(r, contactThere, aside) && findPixel(r, aside, at)) hard = hardAt(at);
            }
        }
#else
        ivec2 at;
        if (!findPixel(r, aside, at)) continue;
        hard = hardAt(at);
#endif
        sum += hard;
        total += 1.0;
    }
    o_visibility = sum / total;
}
