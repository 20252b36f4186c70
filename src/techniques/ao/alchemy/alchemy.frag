// SPDX-License-Identifier: MIT
// A = max(0, 1 - (2 sigma / s) sum max(0, v.n + z beta) / (v.v + epsilon))^k (McGuire et al. 2011, equation 10), v from the
// receiver to the surface found at a sample.
#include "ao/alchemy/params"
#include "shared/screen_ao.glsl"
#include "shared/obscurance.glsl"

layout(location = 0) out float o_visibility;

void main() {
    AoPoint at;
    if (!aoPoint(at)) {
        o_visibility = 1.0;
        return;
    }

    // Points of the disk that the ball of radius r projects to, even in area: a golden spiral with a ring for each sample, turned
    // and moved within the rings by noise (the paper leaves the choice of points open).
    vec2 noise = aoNoise(at.px);
    float bias_m = -at.p_view.z * params.bias, epsilon_m = params.epsilon * at.radius_m;
    float sum = 0.0;
    int total = 0;
    for (int i = 0; i < SAMPLES; ++i) {
        float rho_px = at.radius_px * sqrt((float(i) + noise.y) / float(SAMPLES));
        float phi = AO_TWO_PI * fract(noise.x + float(i) * 0.61803399);
        vec2 at_px = at.center_px + rho_px * vec2(cos(phi), sin(phi));
        // Nothing is known outside the picture. The sky is open.
        if (!aoIsInside(at_px)) continue;
        ++total;
        vec3 q_view;
        if (aoSurface(at_px, q_view)) sum += obscuranceFrom(at, q_view - at.p_view, bias_m, epsilon_m);
    }

    // sigma counts in radii: the sum has the unit 1/m, so that metres would make the answer depend on the scene's scale.
    float occlusion = total > 0 ? 2.0 * params.intensity * at.radius_m * sum / float(total) : 0.0;
    o_visibility = pow(clamp(1.0 - aoOwnShare(at) - occlusion, 0.0, 1.0), params.contrast);
}
