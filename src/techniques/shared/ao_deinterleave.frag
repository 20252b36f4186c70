// SPDX-License-Identifier: MIT
// The G-buffer's depths by parts; 0 where a part has no pixel, as for the sky.
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"
#include "shared/ao_parts.glsl"

layout(location = 0) out float o_depth;

void main() {
    ivec2 px = aoPixelOfPart(ivec2(gl_FragCoord.xy));
    o_depth = all(lessThan(px, ivec2(frameViewport.xy))) ? gbufferDepth(px) : 0.0;
}
