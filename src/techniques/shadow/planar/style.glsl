// SPDX-License-Identifier: MIT
// What a shadow lets through of the light, in colour, by the style. `caster` is the caster's base colour (STYLE_TEXTURED).
#include "shadow/planar/params"

// 1 between the hatches and 0 on them: stripes along the diagonal of the plane's own axes.
float betweenHatches(vec3 p_world, vec3 n) {
    vec3 a = abs(n.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
    vec3 u = normalize(cross(a, n)), v = cross(n, u);
    float across = dot(p_world, (u + v) * 0.70710678) / params.hatch;
    // One pixel wide ramps, so that far stripes turn grey.
    float wide = max(fwidth(across), 1e-6);
    float fromEdge = abs(fract(across) - 0.5) - 0.25;
    return mix(clamp(0.5 + fromEdge / wide, 0.0, 1.0), 0.5, clamp(2.0 * wide - 0.5, 0.0, 1.0));
}

vec3 passedByShadow(vec3 caster, vec3 p_world, vec3 n) {
#if STYLE == STYLE_TINTED
    vec3 own = params.tint;
#elif STYLE == STYLE_TEXTURED
    vec3 own = caster;
#elif STYLE == STYLE_HATCHED
    vec3 own = vec3(betweenHatches(p_world, n));
#else
    vec3 own = vec3(0.0);
#endif
    return 1.0 - params.opacity * (1.0 - own);
}

// The one number for it: luminance (Rec. 709).
float visibilityOf(vec3 passed) { return dot(passed, vec3(0.2126, 0.7152, 0.0722)); }
