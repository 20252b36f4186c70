// SPDX-License-Identifier: MIT
// exp(-c d) times the mean of exp(c z), which is close to 1 where z >= d and to 0 where z is well before (Annen et al. 2008, equation 4).
#include "shadow/esm/params"
#include "shared/moment_map.glsl"
#include "shadow/esm/esm_moments.glsl"

float quotient(float stored, float z) {
#if SPACE == SPACE_LOG
    return exp(min(u_exponent * (stored - z), 80.0));   // what is more is as good as that, and no infinity
#else
    return stored * exp(-u_exponent * z);
#endif
}

float shadowVisibility(vec3 p_world, vec3 n_world) {
    MomentPoint m;
    if (!momentPoint(p_world, n_world, m)) return 1.0;
    // The mean along the footprint is one of exponentials, too, and is limited as a whole: on a slope the near half alone is darker than 1.
    float first = 0.5 - 0.5 * m.lookups, sum = 0.0;
    for (float i = 0.0; i < m.lookups; ++i) sum += quotient(momentsBeside(m, m.along * (first + i), 0).x, m.z);
    return withoutBleeding(min(sum / m.lookups, 1.0));
}
