// SPDX-License-Identifier: MIT
// A = 1 - 1/(2 pi) integral over directions theta of (sin h - sin t), what raises the horizon h weighted by W = 1 - (|v| / R)^2
// (Bavoil, Sainz and Dimitrov 2008).
#include "ao/hbao/params"
#include "shared/screen_ao.glsl"

layout(location = 0) out float o_visibility;

// Elevation of a plane over the one across the line of sight, in the direction `aside`.
float tangentAngle(vec3 n, vec3 aside, vec3 toEye) { return atan(-dot(n, aside), max(dot(n, toEye), 1e-6)); }

void main() {
    AoPoint at;
    if (!aoPoint(at)) {
        o_visibility = 1.0;
        return;
    }

    // Directions about the line of sight. Each spans a plane with it that shows as a line in the picture, so that what lies on the
    // line has that direction. (The view axis in its place turns the own surface into an occluder towards the picture's border.)
    vec3 toEye = aoToEye(at), x, y;
    aoFrame(toEye, x, y);
    vec2 noise = aoNoise(at.px);
    float perRadius2 = 1.0 / (at.radius_m * at.radius_m);
    float occlusion = 0.0;
    for (int i = 0; i < DIRECTIONS; ++i) {
        float theta = AO_TWO_PI * (float(i) + noise.x) / float(DIRECTIONS);
        vec3 aside = x * cos(theta) + y * sin(theta);
        vec2 along = aside.xy;
        if (!isOrthographic()) along = (along + at.p_view.xy * (aside.z / -at.p_view.z)) / -at.p_view.z;
        along *= 0.5 * at.radius_m * frameViewport.xy / frameProjection.zw;

        // The paper has one normal. Surfaces count from the higher of both planes on; between them is the own surface.
        float start_rad = max(tangentAngle(at.n_view, aside, toEye), tangentAngle(at.ng_view, aside, toEye));
        float horizon = sin(min(0.25 * AO_TWO_PI, start_rad + params.angle_bias));

        // The horizon rises from sample to sample, each rise weighted by the distance of the sample that made it.
        for (int j = 0; j < STEPS; ++j) {
#if JITTER
            vec2 at_px = at.center_px + along * ((float(j) + noise.y) / float(STEPS));
#else
            vec2 at_px = at.center_px + along * (float(j + 1) / float(STEPS));
#endif
            if (!aoIsInside(at_px)) break;
            vec3 q_view;
            if (!aoSurface(at_px, q_view)) continue;
            vec3 v = q_view - at.p_view;
            float distance2 = dot(v, v), weight = 1.0 - distance2 * perRadius2;
            if (distance2 == 0.0 || weight <= 0.0) continue;
            float rise = dot(v, toEye) * inversesqrt(distance2);
            occlusion += weight * max(0.0, rise - horizon);
            horizon = max(horizon, rise);
        }
    }

    // What the own surface blocks is weighted by the cosine, as in the truth T1: weighted evenly it is as large as the angle between
    // the normals (bumpy: 5 dB below the best constant in the place of what hbao.md says).
    o_visibility = clamp(1.0 - aoOwnShare(at) - occlusion / float(DIRECTIONS), 0.0, 1.0);
}
