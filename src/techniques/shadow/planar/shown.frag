// SPDX-License-Identifier: MIT
// One colour where the stencil lets it through.
uniform vec3 u_color;
layout(location = 0) out vec4 o_color;

void main() { o_color = vec4(u_color, 1.0); }
