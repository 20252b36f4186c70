// SPDX-License-Identifier: MIT
// The visibility image of a technique that answers at any point (shared/shadow_lookup.h).
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"
#include "ombrage/shadow_lookup"

in vec3 v_rayStart;
in vec3 v_rayAlong;
layout(location = 0) out float o_visibility;

void main() {
    ivec2 px = ivec2(gl_FragCoord.xy);
    o_visibility = shadowVisibility(positionOnRay(v_rayStart, v_rayAlong, gbufferDepth(px)), gbufferGeometricNormal(px));
}
