// SPDX-License-Identifier: MIT
// What one edge adds to the light that a visible point sees: the part of the light beyond it.
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"
#include "shadow/wedges/coverage.glsl"

layout(location = 0) out vec4 o_share;   // shares and counts, of the sides turned away and of the lit ones

flat in vec3 v_a;
flat in vec3 v_b;

uniform vec2 u_sums;   // 1 where it is added

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = gbufferDepth(pixel);
    vec3 p_world = (frame.worldFromView * vec4(positionViewFromDepth(gl_FragCoord.xy * frame.viewport.zw, depth), 1.0)).xyz;
    LightOutline outline = outlineOf(p_world);
    if (!outline.seen) discard;

    // The edge as the receiver sees it before the light's plane: the part between the receiver and the light, and not far
    // beside the light, where projected coordinates would lose their digits.
    vec3 a = projected(outline, v_a - p_world), b = projected(outline, v_b - p_world);
    vec2 range = vec2(0.0, 1.0);
    float least = kSmallest * outline.distance_m;
    keepPositive(a.z - least, b.z - least, range);
    if (!LIGHT_IS(LIGHT_SUN)) keepPositive(outline.distance_m - a.z, outline.distance_m - b.z, range);
    keepPositive(2.0 * a.z - a.x, 2.0 * b.z - b.x, range);
    keepPositive(2.0 * a.z + a.x, 2.0 * b.z + b.x, range);
    keepPositive(2.0 * a.z - a.y, 2.0 * b.z - b.y, range);
    keepPositive(2.0 * a.z + a.y, 2.0 * b.z + b.y, range);
    if (range.y <= range.x) discard;
    vec3 from = mix(a, b, range.x), to = mix(a, b, range.y);

    vec3 horizon = vec3(1.0, 0.0, 1e6);
    if (HORIZON != 0) horizon = horizonOf(outline, gbufferGeometricNormal(pixel));
    float share = shareBeyond(from.xy / from.z, to.xy / to.z, horizon) / kOutlineArea;
    if (share == 0.0) discard;
    o_share = (share * outline.turn) * vec4(u_sums.x, 0.0, u_sums.y, 0.0);
}
