// SPDX-License-Identifier: MIT
// A point of a surface before a map of moments (techniques/shared/moment_map.h), and the map's filtered value there. Include the
// technique's params first.
#include "shared/map_point.glsl"
#include "shared/moment_range.glsl"

#if LIGHT_VIEWS * MOMENT_SHEETS == 1
layout(binding = 5) uniform sampler2D t_moments;
#else
layout(binding = 5) uniform sampler2DArray t_moments;
#endif

struct MomentPoint {
    int view;
    vec2 uv;
    vec2 along;      // the pixel's footprint in the map: from one lookup to the next, middle to middle
    float lookups;   // so many of them
    float level;     // of the mipmaps
    float z;         // what to compare with the map, biased
    float texel;     // a texel's size there, in z
    float spread;    // standard deviation of all filters together, in texels
    float slope;     // tangent of the light's angle to the normal, limited
};

// How the map's coordinates change with a step over the tangent plane.
vec2 momentStep(MapPoint at, vec3 step_world) {
    vec2 lateral = vec2(dot(step_world, VIEW_RIGHT(at.view).xyz), dot(step_world, VIEW_UP(at.view).xyz)) * VIEW_SCALES(at.view).xy;
    if (LIGHT_PERSPECTIVE != 0)
        lateral = (lateral - (at.uv * 2.0 - 1.0) * dot(step_world, VIEW_FORWARD(at.view).xyz)) / at.distance_m;
    return 0.5 * lateral;
}

// The pixel's footprint from the tangent plane: differences between pixels mean nothing at silhouettes and between cube faces. A filter as wide
// as the pixel keeps the picture from flickering, and the blur, of this variance in texels squared, is one already: mipmaps and lookups add
// what it lacks. Returns what they add along the longer axis.
float momentFootprint(MapPoint at, vec3 p_world, vec3 n_world, float resolution, float blurred, inout MomentPoint m) {
    vec3 fromEye = p_world - frameEye.xyz;
    float viewDepth_m = dot(fromEye, frameForward.xyz);
    vec3 along = isOrthographic() ? frameForward.xyz : fromEye / viewDepth_m;
    float pixel_texels = pixelSizeAt(viewDepth_m) * resolution;
    // Flatter than 1 in 20 a pixel sees no plane any more.
    float cosine = dot(n_world, along);
    cosine = abs(cosine) > 0.05 ? cosine : 0.05;
    vec2 right = pixel_texels * momentStep(at, PIXEL_RIGHT - along * (dot(n_world, PIXEL_RIGHT) / cosine));
    vec2 up = pixel_texels * momentStep(at, PIXEL_UP - along * (dot(n_world, PIXEL_UP) / cosine));

    // The axes of the ellipse that both span: eigenvalues and the first eigenvector of their sum of squares.
    vec3 squares = vec3(right.x * right.x + up.x * up.x, right.y * right.y + up.y * up.y, right.x * right.y + up.x * up.y);
    float apart = sqrt((squares.x - squares.y) * (squares.x - squares.y) + 4.0 * squares.z * squares.z);
    // A box as wide as the pixel has the variance 1/12 of its width squared.
    vec2 lacking = max((squares.x + squares.y + vec2(apart, -apart)) * (1.0 / 24.0) - blurred, 0.0);
    if (lacking.x <= 0.0) return 0.0;

    // A level whose texels are w wide adds (w^2 - 1)/12 by their size and twice that by the lookup between them. N lookups sqrt(3/2) w apart add
    // (N^2 - 1)/8 w^2; farther apart they would leave gaps.
    vec2 widths = 1.0 + 4.0 * lacking;   // squared
    m.lookups = clamp(ceil(sqrt(2.0 * widths.x / widths.y - 1.0)), 1.0, float(params.anisotropy));
    float width = max(widths.y, 2.0 * widths.x / (m.lookups * m.lookups + 1.0));
    m.level = 0.5 * log2(width);
    if (m.lookups > 1.0) {
        float side = 0.5 * (abs(squares.x - squares.y) + apart);
        vec2 major = squares.x >= squares.y ? vec2(side, squares.z) : vec2(squares.z, side);
        float gap = sqrt(max(3.0 * (widths.x - width), 0.0) / (m.lookups * m.lookups - 1.0));
        m.along = major * inversesqrt(max(dot(major, major), 1e-30)) * (gap / resolution);
    }
    return lacking.x;
}

// False where there is nothing to look up and the answer is "lit".
bool momentPoint(vec3 p_world, vec3 n_world, out MomentPoint m) {
    n_world = normalize(n_world);
    float resolution = float(textureSize(t_moments, 0).x), perResolution = 1.0 / resolution;
    MapPoint at;
    if (!mapPoint(p_world, n_world, MOMENT_RANGE.w, perResolution, at)) return false;
    // Outside the map nothing casts.
    if (any(lessThan(at.uv, vec2(0.0))) || any(greaterThanEqual(at.uv, vec2(1.0)))) return false;
    m.view = at.view;
    m.uv = at.uv;
    m.slope = at.slope;
    m.along = vec2(0.0);
    m.lookups = 1.0;
    m.level = 0.0;

    float variance = MOMENT_RANGE.z;
#if MIPMAPS
    variance += momentFootprint(at, p_world, n_world, resolution, variance, m);
#endif
    m.spread = sqrt(variance);

    // The mean over a plane is its depth in the filter's middle, whatever the slope: biases that follow the slope have nothing to do.
#if BIAS == BIAS_ADAPTIVE || BIAS == BIAS_RECEIVER_PLANE
    float compared_m = at.distance_m - params.constant_bias * at.texel_m - lightViewPrecision(at.view, at.distance_m);
#else
    float compared_m = mapDistance(at, at.uv, vec2(0.0));
#endif
    // A corner's other surface brings the mean of a Gaussian nearer by 0.4 standard deviations of what it stands before this one's plane.
    compared_m -= mapCorner(at.slope, params.crease) * 0.4 * m.spread * at.texel_m;
    m.z = momentDepth(compared_m);
    m.texel = at.texel_m * MOMENT_RANGE.y;
    return true;
}

// One lookup, so far beside the point: the footprint is covered by `lookups` of them, `along` apart.
vec4 momentsBeside(MomentPoint m, vec2 beside, int sheet) {
#if LIGHT_VIEWS * MOMENT_SHEETS == 1
    return textureLod(t_moments, m.uv + beside, m.level);
#else
    return textureLod(t_moments, vec3(m.uv + beside, float(m.view * MOMENT_SHEETS + sheet)), m.level);
#endif
}

// The filtered statistics there.
vec4 momentsAt(MomentPoint m, int sheet) {
#if MIPMAPS
    float first = 0.5 - 0.5 * m.lookups;
    vec4 sum = momentsBeside(m, m.along * first, sheet);
    for (float i = 1.0; i < m.lookups; ++i) sum += momentsBeside(m, m.along * (first + i), sheet);
    return sum / m.lookups;
#else
    return momentsBeside(m, vec2(0.0), sheet);
#endif
}

// Chebyshev's inequality, one-tailed: at most this share of a distribution with such moments lies at t or beyond (Donnelly, Lauritzen
// 2006, equation 2).
float chebyshevBound(vec2 moments, float t, float smallestVariance) {
    float beyond = t - moments.x;
    if (beyond <= 0.0) return 1.0;
    float variance = max(moments.y - moments.x * moments.x, smallestVariance);
    return variance / (variance + beyond * beyond);
}

// Light bleeding reduction (Lauritzen 2007, GPU Gems 3, section 8.4.3).
float withoutBleeding(float visibility) { return clamp((visibility - params.bleeding) / (1.0 - params.bleeding), 0.0, 1.0); }
