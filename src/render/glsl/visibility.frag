// SPDX-License-Identifier: MIT
// The visibility image of a technique that answers at any point (ShadowLookupTechnique).
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"
#include "ombrage/shadow_lookup"

noperspective in vec2 v_pixel;
noperspective in vec3 v_rayStart;
noperspective in vec3 v_rayAlong;
layout(location = 0) out float o_visibility;

void main() {
    ivec2 px = ivec2(v_pixel);
    o_visibility = shadowVisibility(positionOnRay(v_rayStart, v_rayAlong, gbufferDepth(px)), geometricDirectionOf(gbufferSurface(px)));
}
