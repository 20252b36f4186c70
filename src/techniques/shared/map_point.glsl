// SPDX-License-Identifier: MIT
// A point of a surface as a light's map sees it, and what to compare with a texel of the map, by the technique's bias (MapParams in
// techniques/shared/map_params.h). Include the technique's params first.
#include "ombrage/light.glsl"
#include "shared/light_views.glsl"

struct MapPoint {
    vec3 p_world, n_world;   // moved by the bias that moves
    int view;
    vec2 uv;                 // in the map, [0,1] inside
    float distance_m;        // along the view's axis
    float texel_m;           // world size of a texel there
    float slope;             // tangent of the light's angle to the normal, limited
    vec2 gradient;           // of the distance over uv, of BIAS_RECEIVER_PLANE
};

// `reach` is how far lookups go beside the point, in texels; that within the nearest texel is included. False where there is nothing to
// shade: faces turned away and what is beyond the light's range, where lighting is 0 anyway.
bool mapPoint(vec3 p_world, vec3 n_world, float reach, float perResolution, out MapPoint at) {
#if BIAS != BIAS_ADAPTIVE
    n_world = normalize(n_world);   // a tangent plane needs no length
#endif
    float lightDistance_m;
    vec3 l = directionToLight(p_world, lightDistance_m);
    float cosine = dot(n_world, l);
    bool isLit = cosine > 0.0 && irradianceFacing(l, lightDistance_m) != vec3(0.0);
#if BIAS != BIAS_RECEIVER_PLANE
    if (!isLit) return false;   // neighbours need the derivatives
#endif

    at.p_world = p_world;
    at.n_world = n_world;
    at.view = lightViewOf(p_world);
    at.uv = lightViewUv(at.view, p_world, at.distance_m);
    at.texel_m = lightViewTexelAt(at.view, at.uv, at.distance_m, perResolution);
    // Of normals of any length.
    float sine = sqrt(max(dot(n_world, n_world) - cosine * cosine, 0.0));
    at.slope = min(sine / max(cosine, 1e-6), params.max_slope);
    at.gradient = vec2(0.0);

#if BIAS == BIAS_NORMAL_OFFSET
    // Holbert 2011: move the receiver off its surface, the more the flatter the light.
    at.p_world += n_world * (params.normal_offset * at.texel_m * sine * (1.0 + reach));
    at.uv = lightViewUv(at.view, at.p_world, at.distance_m);
#elif BIAS == BIAS_RECEIVER_PLANE
    // Isidoro 2006: the plane's depth gradient in the map from screen-space derivatives.
    vec3 dx = dFdx(vec3(at.uv, at.distance_m)), dy = dFdy(vec3(at.uv, at.distance_m));
    float determinant = dx.x * dy.y - dx.y * dy.x;
    at.gradient = vec2(dy.y * dx.z - dx.y * dy.z, dx.x * dy.z - dy.x * dx.z) / (abs(determinant) > 1e-20 ? determinant : 1e20);
#endif
    return isLit;
}

// How far, for each unit aside, the other surface of a concave corner of a right angle stands before the plane of one at this slope; at most `most`, for
// casters that touch a surface look the same.
float mapCorner(float slope, float most) { return min(slope + 1.0 / max(slope, 1e-3), most); }

// Distance to compare with what the map holds at a texel's centre, which `beside` texels (at least those of the nearest texel) lie
// between it and the point.
float mapDistance(MapPoint at, vec2 center, vec2 beside) {
    float compared_m = at.distance_m;
#if BIAS == BIAS_SLOPE
    // A surface at this slope differs by at most half a texel's diagonal times the slope within the texel, and by more farther off.
    compared_m -= at.texel_m * at.slope * (params.slope_bias + max(length(beside) - 0.70710678, 0.0));
#elif BIAS == BIAS_ORIENTED && (defined(LIGHT_PARABOLOIDS) || defined(LIGHT_TETRAHEDRON))
    // Their axes are not square to each other all over the picture: half a diagonal at the surface's slope.
    compared_m -= at.texel_m * at.slope * max(length(beside), 0.70710678);
#elif BIAS == BIAS_ORIENTED
    // FFXVI 2023: the same from the normal's own direction in the map: half a texel along each axis.
    vec3 n_light = vec3(dot(at.n_world, VIEW_RIGHT(at.view).xyz), dot(at.n_world, VIEW_UP(at.view).xyz), dot(at.n_world, VIEW_FORWARD(at.view).xyz));
    float rise = dot(max(beside, vec2(0.5)), abs(n_light.xy)) / max(abs(n_light.z), 1e-4);
    compared_m -= at.texel_m * min(rise, params.max_slope * max(length(beside), 0.70710678));
#elif BIAS == BIAS_RECEIVER_PLANE
    float steepest = params.max_slope * at.texel_m * max(length(beside), 0.70710678);
    compared_m += clamp(dot(at.gradient, center - at.uv), -steepest, steepest);
#elif BIAS == BIAS_ADAPTIVE
    // Dou et al. 2014: the light's ray through the texel's centre against the receiver's tangent plane.
    float steepest = params.max_slope * at.texel_m * max(length(beside), 0.70710678);
    float plane_m = lightViewPlaneDistance(at.view, center, at.p_world, at.n_world, at.distance_m);
    compared_m += clamp(plane_m - at.distance_m, -steepest, steepest);
#endif
    return compared_m - params.constant_bias * at.texel_m - lightViewPrecision(at.view, at.distance_m);
}

// The same as depth, for comparisons.
float mapReference(MapPoint at, vec2 center, vec2 beside) {
    return clamp(lightViewDepth(at.view, mapDistance(at, center, beside)), 0.0, 1.0);
}
