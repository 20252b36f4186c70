// SPDX-License-Identifier: MIT
// Statistics of each texel's depth.
#include "shared/moment_range.glsl"
#include "shared/moments_of"

#if LIGHT_VIEWS == 1
layout(binding = 5) uniform sampler2D t_depth;
#else
layout(binding = 5) uniform sampler2DArray t_depth;
#endif
uniform int u_view;
uniform int u_sheet;

layout(location = 0) out vec4 o_moments;

void main() {
#if LIGHT_VIEWS == 1
    float depth = texelFetch(t_depth, ivec2(gl_FragCoord.xy), 0).r;
#else
    float depth = texelFetch(t_depth, ivec3(gl_FragCoord.xy, u_view), 0).r;
#endif
    // Nothing casts at depth 0; what is no number counts as nothing, too.
    float z = depth > 0.0 ? momentDepth(lightViewDistance(u_view, min(depth, 1.0))) : 1.0;
    o_moments = momentsOf(z, u_sheet);
}
