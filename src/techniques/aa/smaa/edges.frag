// SPDX-License-Identifier: MIT
// SMAA 1x, first pass: which pixels differ from their left (x) and their lower (y) neighbour (Jimenez et al. 2012, section 4.1).
layout(binding = 5) uniform sampler2D t_encoded;   // luma in alpha
uniform float u_threshold;
uniform float u_localContrast;

layout(location = 0) out vec2 o_edges;

float lumaAt(ivec2 px) { return texelFetch(t_encoded, clamp(px, ivec2(0), textureSize(t_encoded, 0) - 1), 0).a; }

void main() {
    ivec2 px = ivec2(gl_FragCoord.xy);
    float luma = lumaAt(px), left = lumaAt(px - ivec2(1, 0)), below = lumaAt(px - ivec2(0, 1));
    vec2 contrast = abs(luma - vec2(left, below));
    vec2 edges = step(u_threshold, contrast);
    o_edges = vec2(0.0);
    if (edges == vec2(0.0)) return;

    // Local contrast adaptation: next to a much stronger edge a weak one is a part of it.
    vec2 largest = max(contrast, abs(luma - vec2(lumaAt(px + ivec2(1, 0)), lumaAt(px + ivec2(0, 1)))));
    largest = max(largest, abs(vec2(left, below) - vec2(lumaAt(px - ivec2(2, 0)), lumaAt(px - ivec2(0, 2)))));
    o_edges = edges * step(max(largest.x, largest.y), u_localContrast * contrast);
}
