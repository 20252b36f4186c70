// SPDX-License-Identifier: MIT
// Ambient occlusion by slices: half planes about the way to the eye, in which everything that the picture shows within the radius has an
// angle to the eye (Jimenez, Wu, Pesce and Jarabo 2016; techniques/shared/ao_slices.h). Include the technique's params first.
#include "shared/screen_ao.glsl"

const float AO_PI = 3.14159265359, AO_HALF_PI = 1.57079632679;

// Angles run from the way to the eye, positive towards `along`.
struct AoSlice {
    vec3 toEye;
    vec3 along;       // unit, across the way to the eye
    float n_rad;      // of n_s projected into the slice
    float share;      // the length of that projection
    float low_rad;    // between these lies what is above the planes of n_s and of n_g
    float high_rad;
};

// The slice at an angle about the way to the eye. Slices are even about that way, where the paper's are even in the picture: off the
// picture's middle only this is the even measure that eq. 3 integrates over.
AoSlice aoSlice(AoPoint at, vec3 toEye, vec3 t_view, vec3 b_view, float turn_rad) {
    AoSlice slice;
    slice.toEye = toEye;
    slice.along = t_view * cos(turn_rad) + b_view * sin(turn_rad);
    vec2 n = vec2(dot(at.n_view, toEye), dot(at.n_view, slice.along));
    vec2 ng = vec2(dot(at.ng_view, toEye), dot(at.ng_view, slice.along));
    slice.share = length(n);
    slice.n_rad = atan(n.y, n.x);
    float ng_rad = atan(ng.y, ng.x);
    slice.low_rad = max(slice.n_rad, ng_rad) - AO_HALF_PI;
    slice.high_rad = min(slice.n_rad, ng_rad) + AO_HALF_PI;
    return slice;
}

// The integral of cos(t - n) |sin t| from 0 to h, negative for h < 0 (eq. 7 of the paper): what [h1, h2] sees is G(h2) - G(h1), wherever
// the way to the eye lies.
float aoArc(float n_rad, float h_rad) {
    return sign(h_rad) * 0.25 * (cos(n_rad) + 2.0 * h_rad * sin(n_rad) - cos(2.0 * h_rad - n_rad));
}

// The same integral over the hemisphere of n, [n - 90, n + 90] degrees, which holds the way to the eye or not.
float aoWholeArc(float n_rad) { return aoArc(n_rad, n_rad + AO_HALF_PI) - aoArc(n_rad, n_rad - AO_HALF_PI); }

// The end of what is seen on one side of the way to the eye (+1 or -1) under a horizon at an angle to that way.
float aoEnd(AoSlice slice, float side, float horizon_rad) {
    return side > 0.0 ? min(max(horizon_rad, max(slice.low_rad, 0.0)), slice.high_rad)
                      : max(min(-horizon_rad, min(slice.high_rad, 0.0)), slice.low_rad);
}

// How far along a side step `k` lies, in radii: (k + jitter) / STEPS to a power, at least 1.3 pixels aside, where the next pixel begins.
float aoStep(float k, float jitter, float least) {
    return least + (1.0 - least) * pow((k + jitter) * (1.0 / float(STEPS)), params.power);
}

float aoLeastStep(AoPoint at) { return min(1.0, 1.3 / at.radius_px); }

// The surface that the picture shows at `offset` metres aside of the receiver. `isOccluder` where it lies within the radius and over the
// plane of n_g: what does not hides nothing that this plane leaves. False outside the picture, where nothing is known.
bool aoOccluder(AoPoint at, vec3 offset, out vec3 delta_view, out float distance_m, out bool isOccluder) {
    isOccluder = false;
    vec2 at_px;
    if (!aoPlace(at.p_view + offset, at_px) || !aoIsInside(at_px)) return false;
    vec3 q_view;
#if MIPS > 0
    // Each doubling of the way beyond 2^3.3 pixels reads a level coarser (the offset of XeGTAO; McGuire et al. 2012 take 2^3).
    vec2 aside = at_px - at.center_px;
    int level = clamp(int(0.5 * log2(max(dot(aside, aside), 1.0)) - 3.3), 0, MIPS);
    bool isSurface = aoSurfaceOfLevel(at_px, level, q_view);
#else
    bool isSurface = aoSurface(at_px, q_view);
#endif
    delta_view = q_view - at.p_view;
    distance_m = length(delta_view);
    isOccluder = isSurface && distance_m < at.radius_m && dot(delta_view, at.ng_view) > 1e-4 * distance_m;
    return true;
}
