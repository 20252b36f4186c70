// SPDX-License-Identifier: MIT
// V = 2 times the share of a ball's points that lie in front of the surface which their pixel shows.
#include "ao/crytek/params"
#include "shared/screen_ao.glsl"

uniform vec4 u_kernel[PAIRS];   // points of the unit ball

layout(location = 0) out float o_visibility;

// 1 where the point at an offset is open, 0 where it is hidden. False outside the picture, where nothing is known.
bool openAt(AoPoint at, vec3 offset, out float open) {
    vec3 q_view = at.p_view + offset, surface_view;
    vec2 at_px;
    if (!aoPlace(q_view, at_px) || !aoIsInside(at_px)) return false;
    open = 1.0;
    if (!aoSurface(at_px, surface_view)) return true;
    if (surface_view.z > q_view.z) open = 0.0;
    // What stands far in front tells nothing of the surroundings: half, as on a flat surface.
    float reach_m = params.range * at.radius_m, before_m = surface_view.z - at.p_view.z;
    float unknown = before_m <= reach_m ? 0.0 : reach_m > 0.0 ? min(before_m / reach_m - 1.0, 1.0) : 1.0;
    open = mix(open, 0.5, unknown);
    return true;
}

void main() {
    AoPoint at;
    if (!aoPoint(at)) {
        o_visibility = 1.0;
        return;
    }

    // The kernel reflected about a direction of the pixel's own.
    vec3 mirror = aoUnit(aoNoise(at.px));
    float sum = 0.0, total = 0.0;
    for (int i = 0; i < PAIRS; ++i) {
        vec3 offset = reflect(u_kernel[i].xyz, mirror) * at.radius_m;
        float here, opposite;
        // Without its opposite a point would tell on which side of the surface the picture ends.
        if (!openAt(at, offset, here) || !openAt(at, -offset, opposite)) continue;
        sum += here + opposite;
        total += 2.0;
    }
    float open = total > 0.0 ? sum / total : 0.5;
#if REMAP == 1
    open = min(2.0 * open, 1.0);
#endif
    o_visibility = open;
}
