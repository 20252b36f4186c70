// SPDX-License-Identifier: MIT
// Depth and its square, the first two moments once averaged.
#include "shadow/vsm/params"

vec4 momentsOf(float z, int sheet) {
#if BITS == BITS_16
    return vec4(z * 0.5 + 0.5, z * z, 0.0, 0.0);   // both in [0,1]
#else
    return vec4(z, z * z, 0.0, 0.0);
#endif
}
