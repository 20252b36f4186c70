// SPDX-License-Identifier: MIT
// Light that is seen: all of it above the horizon less what is covered, the count of volumes less the edges'
// shares, for the side of the casters that covers more.
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"
#include "shadow/wedges/coverage.glsl"

layout(location = 0) out float o_visibility;

layout(binding = 5) uniform sampler2D t_share;   // wedge.frag

in vec3 v_rayStart;
in vec3 v_rayAlong;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 share = texelFetch(t_share, pixel, 0);
    float above = 1.0;
    if (HORIZON != 0) {
        LightOutline outline = outlineOf(positionOnRay(v_rayStart, v_rayAlong, gbufferDepth(pixel)));
        if (outline.seen) above = aboveHorizon(horizonOf(outline, gbufferGeometricNormal(pixel))) / kOutlineArea;
    }
    float left = above * (1.0 - share.y) + share.x;
#if BOTH_SIDES
    left = min(left, above * (1.0 - share.w) + share.z);
#endif
    o_visibility = clamp(left, 0.0, above);
}
