// SPDX-License-Identifier: MIT
// V = the share of directions, cosine-weighted, whose point lies in front of the surface that its pixel shows.
#include "ao/ssdo/params"
#include "shared/screen_ao.glsl"

uniform vec4 u_kernel[SAMPLES];   // unit directions about z; w the length at which each is tested

layout(location = 0) out float o_visibility;

void main() {
    AoPoint at;
    if (!aoPoint(at)) {
        o_visibility = 1.0;
        return;
    }

    // The kernel over the shading normal, turned about it. Its lengths are moved along too: a turn leaves them the same for all pixels.
    vec2 noise = aoNoise(at.px);
    float turn = AO_TWO_PI * noise.x;
    vec2 axis = vec2(cos(turn), sin(turn));
    vec3 t_view, b_view;
    aoFrame(at.n_view, t_view, b_view);
    vec3 axisX = t_view * axis.x + b_view * axis.y, axisY = b_view * axis.x - t_view * axis.y;

    float open = 0.0, total = 0.0;
    for (int i = 0; i < SAMPLES; ++i) {
        vec4 k = u_kernel[i];
        float along_m = at.radius_m * fract(k.w + noise.y);
        vec3 q_view = at.p_view + (axisX * k.x + axisY * k.y + at.n_view * k.z) * along_m;
        vec3 surface_view;
        vec2 at_px;
        // Nothing is known outside the picture: such a direction counts neither as open nor in N.
        if (!aoPlace(q_view, at_px) || !aoIsInside(at_px)) continue;
        total += 1.0;
        if (!aoSurface(at_px, surface_view) || surface_view.z <= aoClippedZ(at, q_view, at_px)) open += 1.0;
    }
    o_visibility = total > 0.0 ? open / total : 1.0;
}
