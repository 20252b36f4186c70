// SPDX-License-Identifier: MIT
// How many of the depths under the filter lie at the point or beyond, at most, by their first four moments (Peters, Klein 2015).
#include "shadow/msm/params"
#include "shared/moment_map.glsl"
#include "shadow/msm/msm_moments.glsl"
#include "shadow/msm/reconstruction.glsl"

// What rounding can take from the moments, given back by mixing in a distribution that lies far from having few depths.
#if BITS == BITS_16
const float kRounding = 6e-5;
#else
const float kRounding = 3e-7;
#endif
const vec4 kFarFromFew = vec4(0.0, 0.4, 0.0, 0.4);

float shadowVisibility(vec3 p_world, vec3 n_world) {
    MomentPoint m;
    if (!momentPoint(p_world, n_world, m)) return 1.0;
    vec4 moments = mix(readMoments(momentsAt(m, 0)), kFarFromFew, params.moment_bias * kRounding);
    float z0 = m.z - params.spread_bias * m.spread * m.slope * m.texel;
#if RECONSTRUCTION == RECONSTRUCTION_HAMBURGER
    return withoutBleeding(hamburgerBound(moments, z0));
#else
    return withoutBleeding(hausdorffBound(moments, max(z0, -1.0 + 1e-6)));
#endif
}
