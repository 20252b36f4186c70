// SPDX-License-Identifier: MIT
// The finest level of DepthMoments.
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"

uniform int u_margin;

layout(location = 0) out vec2 o_moments;

float linearAt(ivec2 px) {
    float depth = gbufferDepth(px);
    if (isOrthographic()) return -viewDepthFromDepth(depth);
    return depth == 0.0 ? 0.0 : 1.0 / viewDepthFromDepth(depth);
}

void main() {
    ivec2 px = ivec2(gl_FragCoord.xy) - u_margin, last = ivec2(frameViewport.xy) - 1;
    ivec2 edge = clamp(px, ivec2(0), last);
    float value = linearAt(edge);
    // Outside: twice the border's value less that of the pixel as far inside. It stays that of a surface before the eye.
    if (px != edge) {
        float inside = linearAt(clamp(2 * edge - px, ivec2(0), last));
        float beyond = 2.0 * value - inside;
        if (isOrthographic() || beyond > 0.0) value = beyond;
    }
    o_moments = vec2(value, value * value);
}
