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
    float depth = gbufferDepth(ivec2(gl_FragCoord.xy));
    if (depth == 0.0 || gl_FragCoord.z <= 0.0) discard;
    float surface_m = viewDepthFromDepth(depth), side_m = viewDepthFromDepth(gl_FragCoord.z);

    // The weight of the far end, a direction or a point, along the ray from the light.
#ifdef FINITE
    o_distance = v_extrusion * u_distance;
    if (u_toward.w != 0.0) {
        vec2 uv = gl_FragCoord.xy * frame.viewport.zw;
        vec3 p_world = (frame.worldFromView * vec4(positionViewFromDepth(uv, gl_FragCoord.z), 1.0)).xyz;
        o_distance /= distance(p_world, u_toward.xyz);
    }
#else
    o_distance = u_toward.w != 0.0 ? v_extrusion : v_extrusion / max(1.0 - v_extrusion, 1e-7);
#endif
    // Reversed: what is nearer to the surface wins.
    gl_FragDepth = 1.0 / (1.0 + abs(surface_m - side_m) / pixelSizeAt(surface_m));
}
