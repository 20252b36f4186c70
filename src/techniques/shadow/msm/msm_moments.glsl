// SPDX-License-Identifier: MIT
// Four moments of depth, as the format holds them, and the way back.
#include "shadow/msm/params"

#if BITS == BITS_16
// Odd and even polynomials that stay in [0,1] for z in [-1,1] and span the most volume (Peters, Klein 2015, section 3.2).
const mat2 kOdd = mat2(1.5, 0.8660254037844386, -2.0, -0.3849001794597505);   // columns: of z, of z^3
const mat2 kEven = mat2(4.0, 0.5, -4.0, 0.5);                                 // of z^2, of z^4
const mat2 kOddBack = mat2(-0.3333333333333333, -0.75, 1.7320508075688772, 1.299038105676658);
const mat2 kEvenBack = mat2(0.125, -0.125, 1.0, 1.0);

vec4 storedMoments(vec4 moments) { return vec4(kOdd * moments.xz + 0.5, kEven * moments.yw); }

vec4 readMoments(vec4 stored) {
    vec2 odd = kOddBack * (stored.xy - 0.5), even = kEvenBack * stored.zw;
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
