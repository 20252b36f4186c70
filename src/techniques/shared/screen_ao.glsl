// SPDX-License-Identifier: MIT
// A receiver of occlusion that is found in the picture's depths (techniques/shared/screen_ao.h), and the surfaces around it. Include the
// technique's params first.
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"
#include "shared/sample_patterns.glsl"
#include "shared/view_depths.glsl"
#if PIXELS == PIXELS_DEINTERLEAVED
#include "shared/ao_parts.glsl"
layout(binding = 7) uniform sampler2D t_aoParts;    // depths as in the G-buffer
#endif

#if ROTATION == ROTATION_BLUE_NOISE
layout(binding = 5) uniform sampler2D t_aoNoise;    // [0,1), tiles
#endif
layout(binding = 6) uniform sampler2D t_aoDepths;   // of aoSurfaceOfLevel() alone

uniform float u_radius_m;

const float AO_TWO_PI = 6.28318530718;

struct AoPoint {
    ivec2 px;          // of the picture
    vec2 center_px;    // its middle
    vec3 p_view;
    vec3 n_view;       // n_s
    vec3 ng_view;      // n_g
    float radius_m;    // farthest occluder
    float radius_px;   // the same in the picture, where it lies beside the point
};

// The pixel that this invocation stands for.
ivec2 aoPixel() {
#if PIXELS == PIXELS_HALF
    return 2 * ivec2(gl_FragCoord.xy);
#elif PIXELS == PIXELS_DEINTERLEAVED
    return aoPixelOfPart(ivec2(gl_FragCoord.xy));
#else
    return ivec2(gl_FragCoord.xy);
#endif
}

// False where it shows the sky, which is open.
bool aoPoint(out AoPoint at) {
    at.px = aoPixel();
    at.center_px = vec2(at.px) + 0.5;
    // By the same operations as aoSurface(), so that the receiver itself is at distance 0.
    vec2 uv = at.center_px * frameViewport.zw;
    float depth = gbufferDepthAt(uv);
    if (depth == 0.0) return false;
    uvec4 surface = gbufferSurfaceAt(uv);
    at.p_view = positionViewFromDepth(uv, depth);
    at.n_view = mat3(frame.viewFromWorld) * shadingNormalOf(surface);
    at.ng_view = mat3(frame.viewFromWorld) * geometricNormalOf(surface);
    float pixel_m = pixelSizeAt(-at.p_view.z);
    at.radius_m = params.max_radius > 0.0 ? min(u_radius_m, params.max_radius * pixel_m) : u_radius_m;
    at.radius_px = at.radius_m / pixel_m;
    return true;
}

// Of the directions about n_s, weighted by their cosine, the share that lies below n_g's plane: blocked by the receiver's own surface.
float aoOwnShare(AoPoint at) { return 0.5 - 0.5 * dot(at.n_view, at.ng_view); }

// Unit vector towards the eye.
vec3 aoToEye(AoPoint at) { return isOrthographic() ? vec3(0.0, 0.0, 1.0) : normalize(-at.p_view); }

// Where in the picture, in pixels from its lower left corner, a point in view space shows. False behind the eye.
bool aoPlace(vec3 q_view, out vec2 at_px) {
    vec2 plane = q_view.xy / (isOrthographic() ? frameProjection.zw : -q_view.z * frameProjection.zw);
    at_px = (plane * 0.5 + 0.5) * frameViewport.xy;
    return isOrthographic() || q_view.z < 0.0;
}

bool aoIsInside(vec2 at_px) { return all(greaterThanEqual(at_px, vec2(0.0))) && all(lessThan(at_px, frameViewport.xy)); }

// The surface that a place of the picture shows, at the middle of its pixel, or of the nearest pixel of the receiver's own part. False
// where it is the sky.
bool aoSurface(vec2 at_px, out vec3 q_view) {
#if PIXELS == PIXELS_DEINTERLEAVED
    ivec2 part = aoPixel() % AO_PART_STRIDE;
    ivec2 cell = clamp(ivec2(floor((at_px - vec2(part)) / float(AO_PART_STRIDE) + 0.375)), ivec2(0),
                       (ivec2(frameViewport.xy) - 1 - part) / AO_PART_STRIDE);
    vec2 uv = (vec2(cell * AO_PART_STRIDE + part) + 0.5) * frameViewport.zw;
    float depth = texelFetch(t_aoParts, part * aoPartSize() + cell, 0).r;
#else
    vec2 uv = (floor(at_px) + 0.5) * frameViewport.zw;
    float depth = gbufferDepthAt(uv);
#endif
    q_view = positionViewFromDepth(uv, depth);
    return depth != 0.0;
}

// A surface near a place of the picture, from a level of ViewDepths: where its pixel is, as exact as aoSurface().
bool aoSurfaceOfLevel(vec2 at_px, int level, out vec3 q_view) {
    ivec2 texel = min(ivec2(at_px) >> level, textureSize(t_aoDepths, level) - 1);
    float distance_m = texelFetch(t_aoDepths, texel, level).r;
    vec2 plane = ((vec2(viewDepthPixel(texel, level)) + 0.5) * frameViewport.zw * 2.0 - 1.0) * frameProjection.zw;
    q_view = vec3(isOrthographic() ? plane : plane * distance_m, -distance_m);
    return distance_m != 0.0;
}

// Unit vectors across n, without branches (Duff et al. 2017).
void aoFrame(vec3 n, out vec3 t, out vec3 b) {
    float side = n.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (side + n.z), c = n.x * n.y * a;
    t = vec3(1.0 + side * n.x * n.x * a, side * c, -side * n.x);
    b = vec3(c, side + n.y * n.y * a, -n.y);
}

// A unit vector from two numbers of [0,1), even on the sphere: kernels of points are reflected about it.
vec3 aoUnit(vec2 u) {
    float z = 1.0 - 2.0 * u.x, angle = AO_TWO_PI * u.y;
    return vec3(sqrt(max(0.0, 1.0 - z * z)) * vec2(cos(angle), sin(angle)), z);
}

// A point of view space, as seen through the middle of its pixel, lies behind the receiver's own surface by rounding alone where it is over
// the tangent plane: its depth along the view axis, negative like q_view.z, not let behind that plane. A thousandth of the radius covers
// normals and depths as stored.
float aoClippedZ(AoPoint at, vec3 q_view, vec2 at_px) {
    if (dot(q_view - at.p_view, at.ng_view) < 0.0) return q_view.z;
    vec2 plane = ((floor(at_px) + 0.5) * frameViewport.zw * 2.0 - 1.0) * frameProjection.zw;
    vec3 n = at.ng_view;
    float height = dot(n, at.p_view) + 0.001 * at.radius_m;
    if (isOrthographic()) return n.z > 1e-4 ? max(q_view.z, (height - dot(n.xy, plane)) / n.z) : q_view.z;
    // Sight lines that pass over the plane meet it nowhere.
    float along = dot(n, vec3(plane, -1.0));
    return along < 0.0 && height < 0.0 ? max(q_view.z, -height / along) : q_view.z;
}

// Two numbers of [0,1) for a pixel, by the technique's `rotation`: a share of a full turn, and one more that is independent of it.
vec2 aoNoise(ivec2 px) {
#if PIXELS == PIXELS_DEINTERLEAVED
    // One turn for each part, so that neighbouring threads read neighbouring depths.
    px %= AO_PART_STRIDE;
#endif
    uint seed = frame.random.x;
#if ROTATION == ROTATION_NONE
    return vec2(0.0, 0.5);
#elif ROTATION == ROTATION_GRADIENT
    // Each seed looks at another part of the pattern.
    vec2 p = vec2(px) + 5.588238 * float(seed & 63u);
    return vec2(gradientNoise(p), gradientNoise(p.yx + vec2(47.0, 17.0)));
#elif ROTATION == ROTATION_HASH
    uint first = hashOf(hashOf(uint(px.y), seed), uint(px.x));
    return vec2(unitFromBits(first), unitFromBits(hashOf(first, 0x68bc21ebu)));
#elif ROTATION == ROTATION_TILE
    // The 16 numbers of a 4x4 tile, neighbours far apart (ordered dither), moved by the seed; and the same by the transposed tile.
    uvec2 t = (uvec2(px) + uvec2(seed, seed >> 2u)) & 3u;
    uint x = t.x ^ t.y;
    uvec2 order = ((x & 1u) << 3u) | ((t.yx & 1u) << 2u) | (x & 2u) | (t.yx >> 1u);
    return vec2(order) / 16.0;
#else
    // The second is the first's at a place far off.
    ivec2 mask = textureSize(t_aoNoise, 0) - 1;
    ivec2 moved = px + ivec2(seed * uvec2(37u, 17u) & 1023u);
    return vec2(texelFetch(t_aoNoise, moved & mask, 0).r, texelFetch(t_aoNoise, (moved + ivec2(29, 41)) & mask, 0).r);
#endif
}

float aoTurn(ivec2 px) { return aoNoise(px).x; }
