// SPDX-License-Identifier: MIT
// A = max(0, 1 - (5 sigma / (r^6 s)) sum max(0, r^2 - v.v)^3 max(0, (v.n - beta) / (v.v + epsilon))) (McGuire, Mara and Luebke
// 2012), v from the receiver to the surface found at a sample; samples far aside read coarser depths.
#include "ao/sao/params"
#include "shared/screen_ao.glsl"
#include "shared/obscurance.glsl"

layout(location = 0) out float o_visibility;

void main() {
    AoPoint at;
    if (!aoPoint(at)) {
        o_visibility = 1.0;
        return;
    }

    // A spiral of `turns` turns: radii and angles both even in the sample's number (equations 7 and 8).
    float turn = aoTurn(at.px);
    float perRadius2 = 1.0 / (at.radius_m * at.radius_m);
    float bias_m = params.bias * at.radius_m, epsilon_m = params.epsilon * at.radius_m;
    float sum = 0.0;
    int total = 0;
    for (int i = 0; i < SAMPLES; ++i) {
        float alpha = (float(i) + 0.5) / float(SAMPLES);
        float rho_px = at.radius_px * alpha;
        float phi = AO_TWO_PI * (alpha * float(TURNS) + turn);
        vec2 at_px = at.center_px + rho_px * vec2(cos(phi), sin(phi));
        // Nothing is known outside the picture. The sky is open.
        if (!aoIsInside(at_px)) continue;
        ++total;

        // Neighbouring pixels' samples lie as far apart as they are from their receivers: the level in which those are some 2^q
        // texels keeps them in cache (equation 9).
        vec3 q_view;
#if MIPS
        int level = clamp(int(log2(max(rho_px, 1.0)) - params.mip_offset), 0, textureQueryLevels(t_aoDepths) - 1);
        bool isSurface = aoSurfaceOfLevel(at_px, level, q_view);
#else
        bool isSurface = aoSurface(at_px, q_view);
#endif
        if (!isSurface) continue;
        vec3 v = q_view - at.p_view;
        float fall = max(0.0, 1.0 - dot(v, v) * perRadius2);
        sum += fall * fall * fall * obscuranceFrom(at, v, bias_m, epsilon_m);
    }

    // sigma, beta and epsilon count in radii, as in the paper at its r of 1 m: the quotient has the unit 1/m, so that metres would
    // make the answer depend on the scene's scale.
    float occlusion = total > 0 ? 5.0 * params.intensity * at.radius_m * sum / float(total) : 0.0;
    o_visibility = clamp(1.0 - aoOwnShare(at) - occlusion, 0.0, 1.0);
}
