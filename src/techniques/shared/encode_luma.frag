// SPDX-License-Identifier: MIT
// The picture as the eye weighs it: sRGB-encoded colour, and in alpha the luma of what a display can show.
#include "shared/srgb.glsl"

layout(binding = 5) uniform sampler2D t_picture;

layout(location = 0) out vec4 o_encoded;

void main() {
    vec3 encoded = srgbFromLinear(texelFetch(t_picture, ivec2(gl_FragCoord.xy), 0).rgb);
    float luma = dot(min(encoded, vec3(1.0)), vec3(0.2126, 0.7152, 0.0722));
    o_encoded = vec4(encoded, luma);
}
