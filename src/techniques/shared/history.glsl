// SPDX-License-Identifier: MIT
// What the frame before kept of the surface that a pixel shows, found again by depth (Nehab et al. 2007). Needs ombrage/frame.glsl and
// ombrage/gbuffer.glsl; setReprojection() of techniques/shared/history.h puts the uniforms.
#include "ombrage/reprojection.glsl"

uniform mat4 u_viewBefore;
uniform int u_hasHistory;

// Four pixels around a point of the frame before, counted from the lower left one, x first, and their weights: their sum is 1.
struct HistoryTaps {
    ivec2 first;
    vec4 weights;
};

// Where the frame before saw what the pixel around `uv` shows at a depth, not the sky's. False: it did not.
// t_history: in z the distance along its view axis, 0 for the sky; its mean over the taps is handed out.
// tolerance: difference of that distance, as a share of it, beyond which a pixel shows something else.
bool findHistory(sampler2D t_history, vec2 uv, float depth, float tolerance, out HistoryTaps taps, out vec4 past) {
    past = vec4(0.0);
    taps = HistoryTaps(ivec2(0), vec4(0.0));
    vec4 p_world = worldOf(uv, depth);
    float wBefore;
    vec2 at = (uv - motionOf(p_world, wBefore)) * frameViewport.xy - 0.5, f = fract(at);
    if (u_hasHistory == 0 || wBefore <= 0.0) return false;
    float distance_m = -(u_viewBefore * p_world).z;
    taps.first = ivec2(floor(at));

    // Bilinear weights of those that show the surface, over their sum.
    ivec2 last = ivec2(frameViewport.xy) - 1;
    float total = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 corner = ivec2(i & 1, i >> 1), px = taps.first + corner;
        float weight = (corner.x == 1 ? f.x : 1.0 - f.x) * (corner.y == 1 ? f.y : 1.0 - f.y);
        if (weight == 0.0 || any(lessThan(px, ivec2(0))) || any(greaterThan(px, last))) continue;
        vec4 there = texelFetch(t_history, px, 0);
        if (there.z == 0.0 || abs(there.z - distance_m) > tolerance * distance_m) continue;
        past += weight * there;
        taps.weights[i] = weight;
        total += weight;
    }
    if (total == 0.0) return false;
    past /= total;
    taps.weights /= total;
    return true;
}

// The mean of another texture over the same pixels.
vec4 historyOf(sampler2D t_other, HistoryTaps taps) {
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 4; ++i)
        if (taps.weights[i] > 0.0) sum += taps.weights[i] * texelFetch(t_other, taps.first + ivec2(i & 1, i >> 1), 0);
    return sum;
}
