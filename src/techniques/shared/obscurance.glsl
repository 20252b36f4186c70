// SPDX-License-Identifier: MIT
// The estimators of ambient obscurance (McGuire et al. 2011; McGuire, Mara and Luebke 2012). Include shared/screen_ao.glsl first;
// techniques/shared/obscurance.h says the same for the truth.

// (v.n - bias) / (v.v + epsilon^2), never below 0, of a surface at v from the receiver.
float obscuranceFrom(AoPoint at, vec3 v, float bias_m, float epsilon_m) {
    // The papers have one normal. Where shading bends it, what bends into view of it is the receiver's own surface: a surface
    // counts by the lower of its heights over the two planes.
    float rise_m = min(dot(v, at.n_view), dot(v, at.ng_view));
    return max(0.0, rise_m - bias_m) / (dot(v, v) + epsilon_m * epsilon_m);
}
