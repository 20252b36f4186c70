// SPDX-License-Identifier: MIT
// Light that is seen: all of it above the horizon less what is covered, the count of volumes less the edges' shares.
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"
#include "shadow/wedges/coverage.glsl"

layout(location = 0) out float o_visibility;

layout(binding = 5) uniform sampler2D t_share;   // the edges' shares, the count

in vec3 v_rayStart;
in vec3 v_rayAlong;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec2 share = texelFetch(t_share, pixel, 0).xy;
    float above = 1.0;
    if (HORIZON != 0) {
        LightOutline outline = outlineOf(positionOnRay(v_rayStart, v_rayAlong, gbufferDepth(pixel)));
        if (outline.seen) above = aboveHorizon(horizonOf(outline, gbufferGeometricNormal(pixel))) / kOutlineArea;
    }
    o_visibility = clamp(above * (1.0 - share.y) + share.x, 0.0, above);
}
