// SPDX-License-Identifier: MIT
// Chebyshev's bound on warped depths; of two warps the smaller bound holds (Lauritzen 2008).
#include "shadow/evsm/params"
#include "shared/moment_map.glsl"
#include "shadow/evsm/evsm_moments.glsl"

#if BITS == BITS_16F
const float kPrecision = 1.0 / 512.0;       // of the second moment: a few units in the last place
#else
const float kPrecision = 1.0 / 4194304.0;
#endif

// The least deviation, carried over to warped depth by the warp's derivative.
float bound(vec2 moments, float warp, float exponent, float deviation) {
    float least = exponent * warp * deviation;
    return chebyshevBound(moments, warp, max(least * least, kPrecision * moments.y));
}

float shadowVisibility(vec3 p_world, vec3 n_world) {
    MomentPoint m;
    if (!momentPoint(p_world, n_world, m)) return 1.0;
    vec4 moments = momentsAt(m, 0);
    vec2 w = warped(m.z);
    float deviation = params.min_deviation * m.slope * m.texel;
    float visibility = bound(moments.xy, w.x, u_exponents.x, deviation);
#if MOMENTS == MOMENTS_4
    visibility = min(visibility, bound(moments.zw, w.y, u_exponents.y, deviation));
#endif
    return withoutBleeding(visibility);
}
