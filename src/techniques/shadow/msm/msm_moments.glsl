// SPDX-License-Identifier: MIT
// Four moments of depth, as the format holds them, and the way back.
#include "shadow/msm/params"

#if BITS == BITS_16
// Rows of techniques/shadow/msm/quantisation.h, two in a vector, and of their inverses.
uniform vec4 u_odd;    // of z, z^3
uniform vec4 u_even;   // of z^2, z^4
uniform vec4 u_oddBack;
uniform vec4 u_evenBack;

vec2 times(vec4 rows, vec2 v) { return vec2(dot(rows.xy, v), dot(rows.zw, v)); }

vec4 storedMoments(vec4 moments) { return vec4(times(u_odd, moments.xz) + 0.5, times(u_even, moments.yw)); }

vec4 readMoments(vec4 stored) {
    vec2 odd = times(u_oddBack, stored.xy - 0.5), even = times(u_evenBack, stored.zw);
    return vec4(odd.x, even.x, odd.y, even.y);
}
#else
vec4 storedMoments(vec4 moments) { return moments; }
vec4 readMoments(vec4 stored) { return stored; }
#endif

vec4 momentsOf(float z, int sheet) {
    float z2 = z * z;
    return storedMoments(vec4(z, z2, z2 * z, z2 * z2));
}
