// SPDX-License-Identifier: MIT
// How far the visible surface lies from the caster, as the side of a volume that is nearest to it knows: where the side
// meets the surface, at the shadow's edge, exactly that. For a sun in metres; for other lights as a share of the way from the
// light's centre to the surface.
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"
#include "ombrage/light.glsl"

layout(location = 0) out float o_distance;

in float v_extrusion;

uniform float u_distance;   // of volumes that end
uniform vec4 u_toward;

void main() {
    vec2 uv = gl_FragCoord.xy * frame.viewport.zw;
    float depth = gbufferDepth(ivec2(gl_FragCoord.xy));
    float sideDepth = max(gl_FragCoord.z, 1e-9);   // a side's far end lies at infinity
    vec3 p_side = (frame.worldFromView * vec4(positionViewFromDepth(uv, sideDepth), 1.0)).xyz;
    vec3 n_side = cross(dFdx(p_side), dFdy(p_side));
    if (depth == 0.0) discard;
    vec3 p_world = (frame.worldFromView * vec4(positionViewFromDepth(uv, depth), 1.0)).xyz;

    // The weight of the far end, a direction or a point, along the ray from the light.
#ifdef FINITE
    o_distance = v_extrusion * u_distance / (u_toward.w != 0.0 ? distance(p_side, u_toward.xyz) : 1.0);
#else
    o_distance = u_toward.w != 0.0 ? v_extrusion : v_extrusion / max(1.0 - v_extrusion, 1e-7);
#endif
    // Distance of the surface from the side's plane, in sizes of a pixel. Reversed: what is nearer wins.
    float steep = max(length(n_side), 1e-30);
    gl_FragDepth = 1.0 / (1.0 + abs(dot(n_side, p_side - p_world)) / (steep * pixelSizeAt(viewDepthFromDepth(depth))));
}
