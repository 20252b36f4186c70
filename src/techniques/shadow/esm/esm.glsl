// SPDX-License-Identifier: MIT
// exp(-c d) times the mean of exp(c z), which is close to 1 where z >= d and to 0 where z is well before (Annen et al. 2008, equation 4).
#include "shadow/esm/params"
#include "shared/moment_map.glsl"
#include "shadow/esm/esm_moments.glsl"

float shadowVisibility(vec3 p_world, vec3 n_world) {
    MomentPoint m;
    if (!momentPoint(p_world, n_world, m)) return 1.0;
    float stored = momentsAt(m, 0).x;
#if SPACE == SPACE_LOG
    float visibility = exp(u_exponent * min(stored - m.z, 0.0));
#else
    float visibility = stored * exp(-u_exponent * m.z);
#endif
    return withoutBleeding(min(visibility, 1.0));
}
