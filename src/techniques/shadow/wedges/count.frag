// SPDX-License-Identifier: MIT
// Adds a bit of the stencil's count.
layout(location = 0) out vec2 o_share;

uniform float u_count;

void main() { o_share = vec2(0.0, u_count); }
