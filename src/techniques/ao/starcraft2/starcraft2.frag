// SPDX-License-Identifier: MIT
// V = 1 - (s / N) sum occlusion(how far the surface that a point's pixel shows lies in front of it).
#include "ao/starcraft2/params"
#include "shared/screen_ao.glsl"

uniform vec4 u_kernel[SAMPLES];   // points of the unit ball

layout(location = 0) out float o_visibility;

// 1 up to `full`, 0 from `none` on, linear between, to a power; nothing where the surface lies behind the point.
float occlusion(float before_m, float radius_m) {
    if (before_m <= 0.0) return 0.0;
    float full_m = params.full * radius_m, none_m = params.none * radius_m;
    if (before_m >= none_m) return 0.0;
    return before_m <= full_m ? 1.0 : pow((none_m - before_m) / (none_m - full_m), params.power);
}

void main() {
    AoPoint at;
    if (!aoPoint(at)) {
        o_visibility = 1.0;
        return;
    }

    // The kernel reflected about a direction of the pixel's own, and what comes to lie under the surface flipped.
    vec3 mirror = aoUnit(aoNoise(at.px));
    float sum = 0.0, total = 0.0;
    for (int i = 0; i < SAMPLES; ++i) {
        vec3 offset = reflect(u_kernel[i].xyz, mirror) * at.radius_m;
        if (dot(offset, at.n_view) < 0.0) offset = -offset;
        vec3 q_view = at.p_view + offset, surface_view;
        vec2 at_px;
        // Nothing is known outside the picture: such a point counts neither as open nor in N.
        if (!aoPlace(q_view, at_px) || !aoIsInside(at_px)) continue;
        total += 1.0;
        if (aoSurface(at_px, surface_view)) sum += occlusion(surface_view.z - aoClippedZ(at, q_view, at_px), at.radius_m);
    }
    o_visibility = total > 0.0 ? clamp(1.0 - params.intensity * sum / total, 0.0, 1.0) : 1.0;
}
