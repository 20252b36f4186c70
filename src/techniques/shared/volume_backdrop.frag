// SPDX-License-Identifier: MIT
// The scene in grey, lit from the eye: what pictures of volumes are drawn over.
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"

layout(location = 0) out vec4 o_color;

noperspective in vec3 v_rayStart;
noperspective in vec3 v_rayAlong;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = gbufferDepth(pixel);
    float grey = 0.0;
    if (depth > 0.0) {
        vec3 p_world = positionOnRay(v_rayStart, v_rayAlong, depth);
        grey = 0.03 + 0.12 * max(dot(gbufferGeometricNormal(pixel), directionToEye(p_world)), 0.0);
    }
    o_color = vec4(vec3(grey), 1.0);
}
