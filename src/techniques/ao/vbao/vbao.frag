// SPDX-License-Identifier: MIT
// The share of each slice's 32 sectors that nothing covers, where each sample covers from its front to its back (Therrien et al. 2023).
#include "ao/vbao/params"
#include "shared/ao_slices.glsl"

layout(location = 0) out float o_visibility;

const float SECTORS_OF_SLICE = 32.0;

// Where an angle lies among the slice's sectors. Even in the angle, as in the paper; or even in what the slice sees of the cosine-weighted
// hemisphere, so that equal counts are equal visibility.
float sectorOf(AoSlice slice, float low, float whole, float angle_rad) {
#if SECTORS == SECTORS_UNIFORM
    float share = (angle_rad - slice.n_rad + AO_HALF_PI) / AO_PI;
#else
    float inside = clamp(angle_rad, slice.n_rad - AO_HALF_PI, slice.n_rad + AO_HALF_PI);
    float share = (aoArc(slice.n_rad, inside) - low) / whole;
#endif
    return clamp(share, 0.0, 1.0) * SECTORS_OF_SLICE;
}

// The sectors whose middles lie in [first, last].
uint covered(float first, float last) {
    int from = int(first + 0.5), to = int(last + 0.5);
    if (to <= from) return 0u;
    return to - from == 32 ? 0xffffffffu : ((1u << uint(to - from)) - 1u) << uint(from);
}

void main() {
    AoPoint at;
    if (!aoPoint(at)) {
        o_visibility = 1.0;
        return;
    }
    vec3 toEye = aoToEye(at), t_view, b_view;
    aoFrame(toEye, t_view, b_view);
    vec2 noise = aoNoise(at.px);
    float least = aoLeastStep(at);

    float seen = 0.0, all = 0.0;
    for (int k = 0; k < SLICES; ++k) {
        AoSlice slice = aoSlice(at, toEye, t_view, b_view, (float(k) + noise.x) * (AO_PI / float(SLICES)));
        float low = aoArc(slice.n_rad, slice.n_rad - AO_HALF_PI), whole = aoWholeArc(slice.n_rad);
#if SECTORS == SECTORS_UNIFORM
        float weight = 1.0;
#else
        float weight = slice.share * whole;
#endif
        all += weight;
        if (slice.low_rad >= slice.high_rad) continue;

        // What lies below the plane of n_g is covered from the start.
        uint mask = covered(0.0, sectorOf(slice, low, whole, slice.low_rad)) |
                    covered(sectorOf(slice, low, whole, slice.high_rad), SECTORS_OF_SLICE);
        for (int side = 0; side < 2; ++side) {
            float way = side == 0 ? 1.0 : -1.0;
            float jitter = fract(noise.y + 0.61803399 * float(2 * k + side));
            for (int i = 0; i < STEPS; ++i) {
                vec3 delta_view;
                float distance_m;
                bool isOccluder;
                vec3 offset = slice.along * (way * at.radius_m * aoStep(float(i), jitter, least));
                if (!aoOccluder(at, offset, delta_view, distance_m, isOccluder)) break;
                if (!isOccluder) continue;
                // From the front to where the view ray leaves the occluder.
                vec3 back_view = delta_view - toEye * params.thickness;
                float front = way * acos(clamp(dot(delta_view, toEye) / distance_m, -1.0, 1.0));
                float back = way * acos(clamp(dot(back_view, toEye) * inversesqrt(dot(back_view, back_view)), -1.0, 1.0));
                mask |= covered(sectorOf(slice, low, whole, min(front, back)), sectorOf(slice, low, whole, max(front, back)));
            }
        }
        seen += weight * (1.0 - float(bitCount(mask)) / SECTORS_OF_SLICE);
    }
    o_visibility = all > 0.0 ? seen / all : 1.0;
}
