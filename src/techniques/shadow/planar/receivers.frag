// SPDX-License-Identifier: MIT
// Lets a pixel through where the number of its triangle's plane has the bit that the stencil is about to take.
#include "ombrage/gbuffer.glsl"

layout(std430, binding = 3) readonly buffer Planes { uint b_planes[]; };   // per global triangle, four to a word

uniform uint u_bit;
uniform uint u_highest;   // the bits up to this number's are written: larger ones would lose theirs and take another's number

void main() {
    uint triangle = gbufferTriangle(ivec2(gl_FragCoord.xy));
    uint plane = b_planes[triangle >> 2] >> (8u * (triangle & 3u)) & 0xffu;
    if (plane > u_highest || (plane & u_bit) == 0u) discard;
}
