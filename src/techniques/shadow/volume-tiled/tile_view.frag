// SPDX-License-Identifier: MIT
// The class of every tile over the scene, to look at; BOUNDARY_ALONE: 1 at its pixels.
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"

layout(binding = 5) uniform sampler2D t_classes;
layout(location = 0) out vec4 o_color;

in vec2 v_uv;
in vec3 v_rayStart;
in vec3 v_rayAlong;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec2 kind = texelFetch(t_classes, pixel / ONTO_TILES, 0).rg;
#ifdef BOUNDARY_ALONE
    o_color = vec4(kind.r);
#else
    float depth = gbufferDepth(pixel);
    float grey = 0.0;
    if (depth > 0.0) {
        vec3 p_world = positionOnRay(v_rayStart, v_rayAlong, depth);
        grey = 0.15 + 0.85 * max(dot(gbufferGeometricNormal(pixel), directionToEye(p_world)), 0.0);
    }
    // Boundary red, dark blue, lit yellow.
    vec3 tint = kind.r > 0.5 ? vec3(0.8, 0.12, 0.05) : kind.g > 0.5 ? vec3(0.05, 0.1, 0.45) : vec3(0.8, 0.7, 0.3);
    o_color = vec4(tint * grey, 1.0);
#endif
}
