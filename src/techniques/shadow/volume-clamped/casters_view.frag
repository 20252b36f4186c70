// SPDX-License-Identifier: MIT
// Every caster in the colour of what became of its volume, lit from the eye, to look at.
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"
#include "ombrage/instances.glsl"

layout(std430, binding = 11) readonly buffer Tints { vec4 b_tints[]; };   // per instance

layout(location = 0) out vec4 o_color;

noperspective in vec3 v_rayStart;
noperspective in vec3 v_rayAlong;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = gbufferDepth(pixel);
    vec3 color = vec3(0.0);
    if (depth > 0.0) {
        vec3 p_world = positionOnRay(v_rayStart, v_rayAlong, depth);
        float grey = 0.15 + 0.85 * max(dot(gbufferGeometricNormal(pixel), directionToEye(p_world)), 0.0);
        color = b_tints[b_triangles[gbufferTriangle(pixel)]].rgb * grey;
    }
    o_color = vec4(color, 1.0);
}
