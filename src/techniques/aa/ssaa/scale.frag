// SPDX-License-Identifier: MIT
layout(binding = 5) uniform sampler2D t_picture;
uniform float u_scale;

layout(location = 0) out vec4 o_color;

void main() { o_color = texelFetch(t_picture, ivec2(gl_FragCoord.xy), 0) * u_scale; }
