// SPDX-License-Identifier: MIT
// One channel of a texture, as grey.
layout(binding = 5) uniform sampler2D t_texture;
uniform int u_channel;
uniform float u_scale;

layout(location = 0) out float o_value;

void main() { o_value = min(u_scale * texelFetch(t_texture, ivec2(gl_FragCoord.xy), 0)[u_channel], 1.0); }
