// SPDX-License-Identifier: MIT
// Lets through where a mask is set.
layout(binding = 5) uniform sampler2D t_mask;

void main() {
    if (texelFetch(t_mask, ivec2(gl_FragCoord.xy), 0).r == 0.0) discard;
}
