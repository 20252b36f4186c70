// SPDX-License-Identifier: MIT
// One level of the mipmaps of a map that stores logarithms: that of the mean of four exponentials.
#include "shared/moment_range.glsl"
#include "shared/moments_of"
#include "shared/moment_log.glsl"

#ifdef SOURCE_ARRAY
layout(binding = 5) uniform sampler2DArray t_source;
#else
layout(binding = 5) uniform sampler2D t_source;
#endif
uniform int u_layer;

layout(location = 0) out vec4 o_moments;

vec4 momentsAtTexel(ivec2 texel) {
#ifdef SOURCE_ARRAY
    return texelFetch(t_source, ivec3(min(texel, textureSize(t_source, 0).xy - 1), u_layer), 0);
#else
    return texelFetch(t_source, min(texel, textureSize(t_source, 0) - 1), 0);
#endif
}

void main() {
    ivec2 first = 2 * ivec2(gl_FragCoord.xy);
    vec4 a = momentsAtTexel(first), b = momentsAtTexel(first + ivec2(1, 0));
    vec4 c = momentsAtTexel(first + ivec2(0, 1)), d = momentsAtTexel(first + ivec2(1, 1));
    vec4 largest = max(max(a, b), max(c, d));
    vec4 sum = momentsExp(a, largest) + momentsExp(b, largest) + momentsExp(c, largest) + momentsExp(d, largest);
    o_moments = momentsLog(0.25 * sum, largest);
}
