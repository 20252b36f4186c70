// SPDX-License-Identifier: MIT
layout(binding = 5) uniform sampler2D t_history;

layout(location = 0) out float o_share;

void main() { o_share = min(texelFetch(t_history, ivec2(gl_FragCoord.xy), 0).g / 32.0, 1.0); }
