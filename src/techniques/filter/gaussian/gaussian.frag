// SPDX-License-Identifier: MIT
// One direction of a Gaussian blur.
#include "filter/gaussian/params"
#include "ombrage/frame.glsl"

layout(binding = 5) uniform sampler2D t_input;
uniform ivec2 u_step;   // (1,0) or (0,1)

noperspective in vec2 v_uv;
layout(location = 0) out float o_value;

void main() {
    ivec2 px = ivec2(v_uv * frameViewport.xy);
    // What lies outside of the picture has no weight.
    ivec2 size = ivec2(frameViewport.xy);
    int first = -min(params.radius, u_step.x * px.x + u_step.y * px.y);
    int last = min(params.radius, u_step.x * (size.x - 1 - px.x) + u_step.y * (size.y - 1 - px.y));
    float perStep2 = -0.5 * 1.44269504089 / (params.sigma * params.sigma);
    float sum = 0.0, total = 0.0;
    for (int i = first; i <= last; ++i) {
        float weight = exp2(perStep2 * float(i * i));
        sum += weight * texelFetch(t_input, px + i * u_step, 0).r;
        total += weight;
    }
    o_value = sum / total;
}
