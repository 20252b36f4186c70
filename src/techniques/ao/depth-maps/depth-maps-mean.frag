// SPDX-License-Identifier: MIT
// The share of the cosines that is seen; the sky is open.
#include "ombrage/gbuffer.glsl"

layout(binding = 5) uniform sampler2D t_sums;

noperspective in vec2 v_uv;

layout(location = 0) out float o_visibility;

void main() {
    vec2 sums = texture(t_sums, v_uv).rg;
    o_visibility = gbufferDepthAt(v_uv) == 0.0 || sums.y <= 0.0 ? 1.0 : sums.x / sums.y;
}
