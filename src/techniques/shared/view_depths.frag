// SPDX-License-Identifier: MIT
// Level 0 of ViewDepths from the G-buffer, or one level from the next finer one, which is level 0 of the bound texture's range.
#include "ombrage/frame.glsl"
#if OF_GBUFFER == 1
#include "ombrage/gbuffer.glsl"
#else
#include "shared/view_depths.glsl"
layout(binding = 5) uniform sampler2D t_finer;
#endif

layout(location = 0) out float o_depth;

void main() {
    ivec2 px = ivec2(gl_FragCoord.xy);
#if OF_GBUFFER == 1
    float depth = gbufferDepth(px);
    o_depth = depth == 0.0 ? 0.0 : viewDepthFromDepth(depth);
#else
    o_depth = texelFetch(t_finer, finerViewDepth(px), 0).r;
#endif
}
