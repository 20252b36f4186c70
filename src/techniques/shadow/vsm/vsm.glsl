// SPDX-License-Identifier: MIT
// How many of the depths under the filter lie at the point or beyond, at most, by their mean and variance (Donnelly, Lauritzen 2006).
#include "shadow/vsm/params"
#include "shared/moment_map.glsl"

float shadowVisibility(vec3 p_world, vec3 n_world) {
    MomentPoint m;
    if (!momentPoint(p_world, n_world, m)) return 1.0;
    vec2 moments = momentsAt(m, 0).xy;
#if BITS == BITS_16
    moments.x = moments.x * 2.0 - 1.0;
    const float kPrecision = 1.0 / 16384.0;   // of the variance: a few steps of 16 bits
#else
    const float kPrecision = 1.0 / 4194304.0;   // a few units in the last place of 1
#endif
    float deviation = params.min_deviation * m.slope * m.texel;
    return withoutBleeding(chebyshevBound(moments, m.z, max(deviation * deviation, kPrecision)));
}
