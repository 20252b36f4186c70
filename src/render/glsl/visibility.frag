// SPDX-License-Identifier: MIT
// The visibility image of a technique that answers at any point (ShadowLookupTechnique).
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"
#include "ombrage/shadow_lookup"

noperspective in vec2 v_uv;
noperspective in vec3 v_rayStart;
noperspective in vec3 v_rayAlong;
layout(location = 0) out float o_visibility;

void main() {
    o_visibility = shadowVisibility(positionOnRay(v_rayStart, v_rayAlong, gbufferDepthAt(v_uv)), geometricDirectionOf(gbufferSurfaceAt(v_uv)));
}
