// SPDX-License-Identifier: MIT
// V = 1/pi int over slices of |n| int cos(t - n) |sin t| dt between the two horizons (Jimenez et al. 2016, eq. 3 to 7).
#include "ao/gtao/params"
#include "shared/ao_slices.glsl"

#ifdef BENT
layout(location = 0) out vec4 o_bent;
#else
layout(location = 0) out float o_visibility;
#endif

// The integral of cos(t - n) |sin t| (sin t, cos t) from 0 to h.
vec2 bentArc(float n_rad, float h_rad) {
    float a = sin(n_rad), b = cos(n_rad), s3 = sin(3.0 * h_rad - n_rad), c3 = cos(3.0 * h_rad - n_rad);
    vec2 arc = vec2(6.0 * sin(h_rad - n_rad) - s3 - 3.0 * sin(h_rad + n_rad) + 8.0 * a,
                    4.0 * b - c3 - 3.0 * cos(h_rad + n_rad));
    return sign(h_rad) * arc * (1.0 / 12.0);
}

// The angle to the eye of the horizon on one side, at least what the planes of n_s and n_g leave.
float horizonOf(AoPoint at, vec3 toEye, vec3 along, float limit_rad, float jitter) {
    float lowest = cos(clamp(limit_rad, 0.0, AO_PI)), horizon = lowest, least = aoLeastStep(at);
    float perFade = 1.0 / (max(params.falloff, 1e-4) * at.radius_m);
    // The share of a horizon that one step takes back, of what a whole side does.
    float decay = 1.0 - pow(1.0 - params.thickness, 1.0 / float(STEPS));
    for (int k = 0; k < STEPS; ++k) {
        vec3 delta_view;
        float distance_m;
        bool isOccluder;
        vec3 offset = along * (at.radius_m * aoStep(float(k), jitter, least));
        if (!aoOccluder(at, offset, delta_view, distance_m, isOccluder)) break;
        float cosine = lowest;
        if (isOccluder) {
            // Occluders fade out towards the radius ("Bounding the sampling area").
            float weight = clamp((at.radius_m - distance_m) * perFade, 0.0, 1.0);
            cosine = max(lowest, mix(lowest, dot(delta_view, toEye) / distance_m, weight));
        }
        // Eq. 9, the heuristic for thin occluders: a horizon that the next samples do not confirm sinks.
        horizon = cosine >= horizon ? cosine : mix(horizon, cosine, decay);
    }
    return acos(clamp(horizon, -1.0, 1.0));
}

// The fit of light between surfaces of one albedo, of eq. 10.
vec3 withBounces(float v, vec3 albedo) {
    vec3 a = 2.0404 * albedo - 0.3324, b = -4.7951 * albedo + 0.6417, c = 2.7552 * albedo + 0.6903;
    return max(vec3(v), ((v * a + b) * v + c) * v);
}

void main() {
    AoPoint at;
    if (!aoPoint(at)) {
#ifdef BENT
        o_bent = vec4(0.0);
#else
        o_visibility = 1.0;
#endif
        return;
    }
    vec3 toEye = aoToEye(at), t_view, b_view;
    aoFrame(toEye, t_view, b_view);
    vec2 noise = aoNoise(at.px);

    float seen = 0.0, whole = 0.0;
    vec3 bent_view = vec3(0.0);
    for (int k = 0; k < SLICES; ++k) {
        AoSlice slice = aoSlice(at, toEye, t_view, b_view, (float(k) + noise.x) * (AO_PI / float(SLICES)));
        whole += slice.share * aoWholeArc(slice.n_rad);
        if (slice.low_rad >= slice.high_rad) continue;
        // Steps of one side lie between those of the other, and of the slices' (by the golden ratio).
        float jitter = fract(noise.y + 0.61803399 * float(2 * k)), other = fract(jitter + 0.61803399);
        float ahead = horizonOf(at, toEye, slice.along, slice.high_rad, jitter);
        float behind = horizonOf(at, toEye, -slice.along, -slice.low_rad, other);
        float high = aoEnd(slice, 1.0, ahead), low = aoEnd(slice, -1.0, behind);
        seen += slice.share * (aoArc(slice.n_rad, high) - aoArc(slice.n_rad, low));
#ifdef BENT
        vec2 bent = slice.share * (bentArc(slice.n_rad, high) - bentArc(slice.n_rad, low));
        bent_view += slice.along * bent.x + toEye * bent.y;
#endif
    }
#ifdef BENT
    o_bent = vec4(normalize(dot(bent_view, bent_view) > 0.0 ? bent_view : at.n_view) * 0.5 + 0.5, 1.0);
#else
    // By what the same slices see of an open plane, where the paper takes the mean over all: an open plane is 1 then.
    float v = whole > 0.0 ? clamp(seen / whole, 0.0, 1.0) : 1.0;
#if MULTI_BOUNCE
    vec3 albedo = unpackedAlbedo(gbufferSurface(at.px).z);
    const vec3 kLuminance = vec3(0.2126, 0.7152, 0.0722);
    float reflected = dot(kLuminance, albedo);
    v = reflected > 0.0 ? clamp(dot(kLuminance, albedo * withBounces(v, albedo)) / reflected, v, 1.0) : v;
#endif
    o_visibility = v;
#endif
}
