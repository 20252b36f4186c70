// SPDX-License-Identifier: MIT
// Chebyshev's bound in the layer that the point lies in (Lauritzen, McCool 2008): what casts before the layer has depth 0 there, all
// alike, and lets no light through by its own spread.
#include "shadow/lvsm/params"
#include "shared/moment_map.glsl"
#include "shadow/lvsm/lvsm_moments.glsl"

#if BITS == BITS_16
const float kPrecision = 1.0 / 16384.0;   // of the variance: a few steps of 16 bits
#else
const float kPrecision = 1.0 / 4194304.0;
#endif

float shadowVisibility(vec3 p_world, vec3 n_world) {
    MomentPoint m;
    if (!momentPoint(p_world, n_world, m)) return 1.0;
    int layer = 0;
    for (int i = 0; i < LAYERS - 1; ++i) layer += m.z >= u_layers[i].z ? 1 : 0;
    float deviation = params.min_deviation * m.slope * m.texel * u_layers[layer].y;
    return withoutBleeding(chebyshevBound(momentsAt(m, layer).xy, depthInLayer(m.z, layer), max(deviation * deviation, kPrecision)));
}
