// SPDX-License-Identifier: MIT
// Depth warped by exponentials, and its squares (Lauritzen 2008, section 7.2).
#include "shadow/evsm/params"

uniform vec2 u_exponents;   // positive, negative

// Both grow with depth, so that what is farther counts as farther.
vec2 warped(float z) { return vec2(exp(u_exponents.x * z), -exp(-u_exponents.y * z)); }

vec4 momentsOf(float z, int sheet) {
    vec2 w = warped(z);
#if MOMENTS == MOMENTS_4
    return vec4(w.x, w.x * w.x, w.y, w.y * w.y);
#else
    return vec4(w.x, w.x * w.x, 0.0, 0.0);
#endif
}
