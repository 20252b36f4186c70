// SPDX-License-Identifier: MIT
// The share of rays that met nothing; the sky is open.
#include "ombrage/gbuffer.glsl"

layout(binding = 5) uniform sampler2D t_open;

uniform float u_perSamples;

noperspective in vec2 v_uv;

layout(location = 0) out float o_visibility;

void main() {
    o_visibility = gbufferDepthAt(v_uv) == 0.0 ? 1.0 : texture(t_open, v_uv).r * u_perSamples;
}
