// SPDX-License-Identifier: MIT
// What the lookup finds on its way: SHOWN 0 the blockers' mean distance from the light, 1 the penumbra's width, both in metres, 2 where it is
// clipped.
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"
#include "shadow/pcss/pcss.glsl"

noperspective in vec2 v_uv;
noperspective in vec3 v_rayStart;
noperspective in vec3 v_rayAlong;
layout(location = 0) out float o_value;

void main() {
    vec3 p_world = positionOnRay(v_rayStart, v_rayAlong, gbufferDepthAt(v_uv));
    Penumbra found = penumbraAt(p_world, geometricDirectionOf(gbufferSurfaceAt(v_uv)));
    o_value = SHOWN == 0 ? found.blocker_m : SHOWN == 1 ? found.width_m : found.isClipped;
}
