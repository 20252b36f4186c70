// SPDX-License-Identifier: MIT
// V = the volume of the half ball over the surface that is free, as a share of it: by points, by lines along the sight, or by the mean
// and variance of the depths over parts of the ball's outline.
#include "ao/volumetric/params"
#include "shared/screen_ao.glsl"

uniform vec4 u_kernel[SAMPLES];   // points: of the unit ball. Lines, areas: xy in the unit disk, z half the ball's length along the sight there

layout(location = 0) out float o_visibility;

#if SAMPLING == SAMPLING_POINTS

// Free volume and volume.
vec2 freeOf(AoPoint at) {
    vec3 mirror = aoUnit(aoNoise(at.px));
    float thickness_m = params.thickness * at.radius_m * aoToEye(at).z;
    vec2 sum = vec2(0.0);
    for (int i = 0; i < SAMPLES; ++i) {
        vec3 offset = reflect(u_kernel[i].xyz, mirror) * at.radius_m;
#if CLIP == 1
        if (dot(offset, at.n_view) < 0.0) offset = -offset;
#endif
        vec3 q_view = at.p_view + offset, surface_view;
        vec2 at_px;
        if (!aoPlace(q_view, at_px) || !aoIsInside(at_px)) continue;
        bool isHidden = false;
        if (aoSurface(at_px, surface_view)) {
#if CLIP == 1
            float before_m = surface_view.z - aoClippedZ(at, q_view, at_px);
#else
            float before_m = surface_view.z - q_view.z;
#endif
            isHidden = before_m > 0.0 && (thickness_m == 0.0 || before_m < thickness_m);
        }
        sum += vec2(isHidden ? 0.0 : 1.0, 1.0);
    }
    return sum;
}

#else

// The ball at one place of its outline: heights are metres along the sight, from the receiver on towards the eye.
struct Line {
    vec2 at_px;
    vec3 aside;        // from the receiver, across the sight
    float low, high;   // where the part of the ball begins and ends; nothing where high is not above low
};

// How much of a line lies under a surface at a height, or at heights of a mean and a deviation.
float partUnder(Line line, float height) { return clamp(height, line.low, line.high) - line.low; }

#if SAMPLING == SAMPLING_AREAS && DEPTHS == DEPTHS_STEPS
// A share f of it rises over the rest by H, where f H is the mean rise and f H^2 the mean square.
float partUnder(Line line, float plane, float rise, float deviation) {
    float square = rise * rise + deviation * deviation;
    float under = partUnder(line, plane);
    if (rise <= 0.0) return under;
    return mix(under, partUnder(line, plane + square / rise), rise * rise / square);
}
#elif SAMPLING == SAMPLING_AREAS
// ln(1 + e^x)
float softPlus(float x) { return max(x, 0.0) + log(1.0 + exp(-abs(x))); }

// Of a normal distribution, with the logistic function for its integral (Bowling et al. 2009).
float partUnder(Line line, float plane, float rise, float deviation) {
    float mean = plane + rise, scale = deviation / 1.702;
    if (scale < 1e-4 * (line.high - line.low)) return partUnder(line, mean);
    return scale * (softPlus((mean - line.low) / scale) - softPlus((mean - line.high) / scale));
}
#endif

// Along the sight, what a height over a plane across a normal is for each metre across it; finite where the sight is in the plane.
float alongSight(vec3 normal, vec3 eye) {
    float cosine = dot(normal, eye);
    return 1.0 / (abs(cosine) < 1e-4 ? 1e-4 : cosine);
}

#if SAMPLING == SAMPLING_AREAS
layout(binding = 8) uniform sampler2D t_moments;   // DepthMoments
uniform float u_margin;
uniform int u_lastLevel;

// The tangent plane in what DepthMoments averages: its value at a place of the picture, and the change from pixel to pixel.
struct Plane {
    float value;
    vec2 slope;
};

Plane planeAt(AoPoint at, vec2 at_px) {
    vec3 n = at.ng_view;
    vec2 aside = (at_px * frameViewport.zw * 2.0 - 1.0) * frameProjection.zw;
    vec2 step = n.xy * 2.0 * frameViewport.zw * frameProjection.zw;
    float through = dot(n, at.p_view);
    if (isOrthographic()) return Plane((through - dot(n.xy, aside)) / max(n.z, 1e-3), -step / max(n.z, 1e-3));
    through = min(through, -1e-4 * at.radius_m);
    return Plane(dot(n, vec3(aside, -1.0)) / through, step / through);
}

// Mean and deviation, from the tangent plane, of the heights in the square of a level.
vec2 heightsAt(AoPoint at, vec2 at_px, Plane plane, float metres, int level) {
    vec2 moments = textureLod(t_moments, (at_px + u_margin) / vec2(textureSize(t_moments, 0)), float(level)).rg;
    // The plane's own variance among the pixels read: of a square of s pixels, and between the squares interpolated.
    float side = exp2(float(level));
    vec2 between = fract((at_px + u_margin) / side - 0.5);
    vec2 spread = (side * side - 1.0) / 12.0 + side * side * between * (1.0 - between);
    float variance = moments.y - moments.x * moments.x - dot(plane.slope * plane.slope, spread);
    return vec2(moments.x - plane.value, sqrt(max(0.0, variance))) * metres;
}
#endif

// Free volume and volume.
vec2 freeOf(AoPoint at) {
    vec3 eye = aoToEye(at), e1, e2;
    aoFrame(eye, e1, e2);
    float perShading = alongSight(at.n_view, eye), thickness_m = params.thickness * at.radius_m;
    float turn = AO_TWO_PI * aoTurn(at.px);
    vec2 axis = vec2(cos(turn), sin(turn)) * at.radius_m;
    vec2 sum = vec2(0.0);
    for (int i = 0; i < SAMPLES; ++i) {
        vec4 k = u_kernel[i];
        Line line;
        line.aside = e1 * (k.x * axis.x - k.y * axis.y) + e2 * (k.x * axis.y + k.y * axis.x);
        line.high = k.z * at.radius_m;
        line.low = -line.high;
#if CLIP == 1
        // Over the tangent plane is towards the eye, but for shading normals that look away from it.
        float cut = clamp(-dot(at.n_view, line.aside) * perShading, line.low, line.high);
        if (perShading > 0.0) line.low = cut;
        else line.high = cut;
#endif
        if (!aoPlace(at.p_view + line.aside, line.at_px) || !aoIsInside(line.at_px) || line.high <= line.low) continue;

        float hidden = 0.0;
#if SAMPLING == SAMPLING_LINES
        vec3 surface_view;
        if (aoSurface(line.at_px, surface_view)) {
            vec3 found = surface_view - at.p_view;
#if CLIP == 1
            // Of its height over the plane, not of the place of its pixel's middle: on the plane itself nothing is hidden.
            float height = dot(at.n_view, found - line.aside) * perShading;
#else
            float height = dot(found, eye);
#endif
            hidden = partUnder(line, height);
            if (thickness_m > 0.0) hidden -= partUnder(line, height - thickness_m);
        }
#else
        // Squares whose pixels spread as far as those of the area, between two levels.
        float level = clamp(log2(at.radius_px * inversesqrt(float(SAMPLES))), 0.0, float(u_lastLevel));
        int finer = min(int(level), u_lastLevel - 1);
        Plane plane = planeAt(at, line.at_px);
        float metres = isOrthographic() ? 1.0 : at.p_view.z * at.p_view.z / eye.z;
        float height = -dot(at.ng_view, line.aside) * alongSight(at.ng_view, eye);
        for (int coarser = 0; coarser < 2; ++coarser) {
            vec2 heights = heightsAt(at, line.at_px, plane, metres, finer + coarser);
            float part = partUnder(line, height, heights.x, heights.y);
            if (thickness_m > 0.0) part -= partUnder(line, height - thickness_m, heights.x, heights.y);
            hidden += part * (coarser == 1 ? level - float(finer) : 1.0 - level + float(finer));
        }
#endif
        sum += vec2(line.high - line.low - hidden, line.high - line.low);
    }
    return sum;
}

#endif

void main() {
    AoPoint at;
    if (!aoPoint(at)) {
        o_visibility = 1.0;
        return;
    }
    vec2 free = freeOf(at);
#if CLIP == 1
    o_visibility = free.y > 0.0 ? free.x / free.y : 1.0;
#else
    o_visibility = free.y > 0.0 ? min(2.0 * free.x / free.y, 1.0) : 1.0;
#endif
}
