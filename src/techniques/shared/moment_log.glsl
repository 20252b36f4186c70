// SPDX-License-Identifier: MIT
// Sums of exponentials relative to the largest, so that nothing overflows.
vec4 momentsExp(vec4 value, vec4 largest) { return exp(MOMENTS_LOG_EXPONENT * (value - largest)); }
vec4 momentsLog(vec4 sum, vec4 largest) { return largest + log(sum) / MOMENTS_LOG_EXPONENT; }
