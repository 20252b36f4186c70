// SPDX-License-Identifier: MIT
// Adds a bit of the stencil's count.
layout(location = 0) out vec4 o_share;   // as in wedge.frag

uniform vec2 u_count;

void main() { o_share = vec4(0.0, u_count.x, 0.0, u_count.y); }
