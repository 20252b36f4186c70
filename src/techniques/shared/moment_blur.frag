// SPDX-License-Identifier: MIT
// One direction of the blur over a map of moments. RADIUS: texels on either side; ALONG_X: 1 or 0.
#include "shared/moment_range.glsl"
#include "shared/moments_of"
#ifdef MOMENTS_LOG_EXPONENT
#include "shared/moment_log.glsl"
#endif

#ifdef SOURCE_ARRAY
layout(binding = 5) uniform sampler2DArray t_source;
#else
layout(binding = 5) uniform sampler2D t_source;
#endif
uniform int u_layer;
uniform vec2 u_weights[RADIUS + 1];

layout(location = 0) out vec4 o_moments;

vec4 momentsAtTexel(int along) {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    int last = textureSize(t_source, 0).x - 1;
    // A lamp's views end where nothing is asked; beyond a sun's nothing casts.
    if (LIGHT_PERSPECTIVE == 0 && (along < 0 || along > last)) return momentsOf(1.0, u_layer % MOMENT_SHEETS);
    along = clamp(along, 0, last);
    if (ALONG_X != 0) texel.x = along; else texel.y = along;
#ifdef SOURCE_ARRAY
    return texelFetch(t_source, ivec3(texel, u_layer), 0);
#else
    return texelFetch(t_source, texel, 0);
#endif
}

void main() {
    int middle = int(ALONG_X != 0 ? gl_FragCoord.x : gl_FragCoord.y);
#ifdef MOMENTS_LOG_EXPONENT
    vec4 largest = momentsAtTexel(middle);
    for (int i = 1; i <= RADIUS; ++i) largest = max(largest, max(momentsAtTexel(middle - i), momentsAtTexel(middle + i)));
    vec4 sum = u_weights[0].x * momentsExp(momentsAtTexel(middle), largest);
    for (int i = 1; i <= RADIUS; ++i)
        sum += u_weights[i].x * (momentsExp(momentsAtTexel(middle - i), largest) + momentsExp(momentsAtTexel(middle + i), largest));
    o_moments = momentsLog(sum, largest);
#else
    vec4 sum = u_weights[0].x * momentsAtTexel(middle);
    for (int i = 1; i <= RADIUS; ++i) sum += u_weights[i].x * (momentsAtTexel(middle - i) + momentsAtTexel(middle + i));
    o_moments = sum;
#endif
}
