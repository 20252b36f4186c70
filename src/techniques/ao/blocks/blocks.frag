// SPDX-License-Identifier: MIT
// V = 1 - (s / N) sum max(0, n.d - cos(angle)) max(0, 1 - D^2 / r^2), d the unit vector and D the distance from the
// receiver to the surface found at a sample.
#include "ao/blocks/params"
#include "shared/screen_ao.glsl"

uniform vec4 u_kernel[SAMPLES];   // offsets in the unit disk or half ball; w their weight

layout(location = 0) out float o_visibility;

void main() {
    AoPoint at;
    if (!aoPoint(at)) {
        o_visibility = 1.0;
        return;
    }
    vec3 n_view = at.n_view;

    // The kernel turned about its axis, in pixels of the picture or in metres over the surface.
    float turn = AO_TWO_PI * aoTurn(at.px);
    vec2 axis = vec2(cos(turn), sin(turn));
#if OFFSETS == OFFSETS_SCREEN
    vec2 axisX = axis * at.radius_px, axisY = vec2(-axis.y, axis.x) * at.radius_px;
#else
    vec3 t_view, b_view;
    aoFrame(n_view, t_view, b_view);
    vec3 axisX = (t_view * axis.x + b_view * axis.y) * at.radius_m;
    vec3 axisY = (b_view * axis.x - t_view * axis.y) * at.radius_m;
    vec3 axisZ = n_view * at.radius_m;
#endif
    vec3 origin_view = at.p_view + n_view * params.bias;

    float cosAngle = cos(params.angle), perRadius2 = 1.0 / (at.radius_m * at.radius_m);
    float sum = 0.0, total = 0.0;
    for (int i = 0; i < SAMPLES; ++i) {
        vec4 k = u_kernel[i];
#if OFFSETS == OFFSETS_SCREEN
        vec2 at_px = at.center_px + axisX * k.x + axisY * k.y;
#else
        vec2 at_px;
        if (!aoPlace(at.p_view + axisX * k.x + axisY * k.y + axisZ * k.z, at_px)) continue;
#endif
        // Nothing is known outside the picture: such a sample counts neither as open nor in N (algorithm 3 of the
        // method clamps it to the border instead, which repeats the border's surface as occluder).
        if (!aoIsInside(at_px)) continue;
        total += k.w;

        vec3 q_view;
        bool isSky = !aoSurface(at_px, q_view);
        vec3 d = q_view - origin_view;
        float distance2 = dot(d, d);
        float near = 1.0 - distance2 * perRadius2;
        // The sky and the receiver itself are open.
        if (isSky || near <= 0.0 || distance2 == 0.0) continue;
        sum += k.w * near * max(0.0, dot(n_view, d) * inversesqrt(distance2) - cosAngle);
    }
    o_visibility = total > 0.0 ? clamp(1.0 - params.intensity * sum / total, 0.0, 1.0) : 1.0;
}
