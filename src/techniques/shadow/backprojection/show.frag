// SPDX-License-Identifier: MIT
// How many squares of the map a pixel's visibility takes.
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"
#include "shadow/backprojection/backprojection.glsl"

noperspective in vec2 v_uv;
noperspective in vec3 v_rayStart;
noperspective in vec3 v_rayAlong;
layout(location = 0) out float o_value;

void main() {
    vec3 p_world = positionOnRay(v_rayStart, v_rayAlong, gbufferDepthAt(v_uv));
    float visibility = shadowVisibility(p_world, geometricDirectionOf(gbufferSurfaceAt(v_uv)));
    // The visibility keeps the compiler from leaving out what is counted.
    o_value = visibility < 2.0 ? lookups : 0.0;
}
