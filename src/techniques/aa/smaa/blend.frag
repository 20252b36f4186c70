// SPDX-License-Identifier: MIT
// SMAA 1x, third pass: every pixel takes from its neighbours what of it lies beyond its edges (Jimenez et al. 2012, section 4.4).
layout(binding = 5) uniform sampler2D t_picture;   // linear
layout(binding = 6) uniform sampler2D t_weights;

layout(location = 0) out vec4 o_color;

vec4 colorAt(ivec2 px) { return texelFetch(t_picture, clamp(px, ivec2(0), textureSize(t_picture, 0) - 1), 0); }

void main() {
    ivec2 px = ivec2(gl_FragCoord.xy);
    vec4 own = texelFetch(t_weights, px, 0);
    ivec2 size = textureSize(t_weights, 0);
    float up = px.y + 1 < size.y ? texelFetch(t_weights, px + ivec2(0, 1), 0).y : 0.0;
    float right = px.x + 1 < size.x ? texelFetch(t_weights, px + ivec2(1, 0), 0).w : 0.0;

    // Along the axis with the larger share; the other one's edges are the steps of this one's.
    bool sideways = max(own.z, right) > max(own.x, up);
    vec2 share = sideways ? vec2(own.z, right) : vec2(own.x, up);
    ivec2 along = sideways ? ivec2(1, 0) : ivec2(0, 1);
    vec4 middle = colorAt(px);
    // Unlike the paper, which blends twice and takes the mean, both shares count in full: they are areas of one pixel.
    o_color = share == vec2(0.0) ? middle
                                 : middle * (1.0 - share.x - share.y) + colorAt(px - along) * share.x + colorAt(px + along) * share.y;
}
