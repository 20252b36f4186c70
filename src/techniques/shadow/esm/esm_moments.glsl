// SPDX-License-Identifier: MIT
// exp(c z), or z itself where the blur takes logarithms.
#include "shadow/esm/params"

uniform float u_exponent;

#if SPACE == SPACE_LOG
#define MOMENTS_LOG_EXPONENT u_exponent   // moment_blur.frag and moment_mip.frag sum exp(exponent * value)
vec4 momentsOf(float z, int sheet) { return vec4(z, 0.0, 0.0, 0.0); }
#else
vec4 momentsOf(float z, int sheet) { return vec4(exp(u_exponent * z), 0.0, 0.0, 0.0); }
#endif
