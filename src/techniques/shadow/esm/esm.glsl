// SPDX-License-Identifier: MIT
// exp(-c d) times the mean of exp(c z), which is close to 1 where z >= d and to 0 where z is well before (Annen et al. 2008, equation 4).
#include "shadow/esm/params"
#include "shared/moment_map.glsl"
#include "shadow/esm/esm_moments.glsl"

float litShare(float stored, float z) {
#if SPACE == SPACE_LOG
    return exp(u_exponent * min(stored - z, 0.0));
#else
    return min(stored * exp(-u_exponent * z), 1.0);
#endif
}

float shadowVisibility(vec3 p_world, vec3 n_world) {
    MomentPoint m;
    if (!momentPoint(p_world, n_world, m)) return 1.0;
    // Lookups along the footprint are averaged as visibilities: the mean of logarithms is that of nothing.
    float first = 0.5 - 0.5 * m.lookups, sum = 0.0;
    for (float i = 0.0; i < m.lookups; ++i) sum += litShare(momentsBeside(m, m.along * (first + i), 0).x, m.z);
    return withoutBleeding(sum / m.lookups);
}
