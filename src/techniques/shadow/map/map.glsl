// SPDX-License-Identifier: MIT
// One comparison with the nearest texel of the light's map, after the chosen bias.
#include "ombrage/light.glsl"
#include "shared/light_views.glsl"
#include "shadow/map/params"

#if LIGHT_VIEWS == 1
layout(binding = 5) uniform sampler2DShadow t_map;
#else
layout(binding = 5) uniform sampler2DArrayShadow t_map;
#endif

float shadowVisibility(vec3 p_world, vec3 n_world) {
#if BIAS != BIAS_ADAPTIVE
    n_world = normalize(n_world);   // a tangent plane needs no length
#endif
    float lightDistance_m;
    vec3 l = directionToLight(p_world, lightDistance_m);
    float cosine = dot(n_world, l);
    // Nothing to do for faces turned away and beyond the light's range: lighting is 0 there anyway.
    if (cosine <= 0.0 || irradianceFacing(l, lightDistance_m) == vec3(0.0)) return 1.0;

    int view = lightViewOf(p_world);
    float resolution = float(textureSize(t_map, 0).x), perResolution = 1.0 / resolution;
    float distance_m;
    vec2 uv = lightViewUv(view, p_world, distance_m);
    float texel_m = lightViewTexel(view, distance_m, perResolution);
    float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
    float slope = min(sine / cosine, params.max_slope);

#if BIAS == BIAS_NORMAL_OFFSET
    // Holbert 2011: move the receiver off its surface, the more the flatter the light.
    p_world += n_world * (params.normal_offset * texel_m * sine);
    uv = lightViewUv(view, p_world, distance_m);
#endif

    // The map's answer belongs to the centre of the nearest texel.
    vec2 center = (floor(uv * resolution) + 0.5) * perResolution;
    float compared_m = distance_m;

#if BIAS == BIAS_SLOPE
    // A surface at this slope differs by at most half a texel's diagonal times the slope within the texel.
    compared_m -= params.slope_bias * texel_m * slope;
#elif BIAS == BIAS_ORIENTED
    // FFXVI 2023: the same from the normal's own direction in the map: half a texel along each axis.
    vec3 n_light = vec3(dot(n_world, VIEW_RIGHT(view).xyz), dot(n_world, VIEW_UP(view).xyz), dot(n_world, VIEW_FORWARD(view).xyz));
    float reach = (abs(n_light.x) + abs(n_light.y)) / max(abs(n_light.z), 1e-4);
    compared_m -= 0.5 * texel_m * min(reach, params.max_slope * 1.41421356);
#elif BIAS == BIAS_RECEIVER_PLANE
    // Isidoro 2006: the plane's depth gradient in the map from screen-space derivatives, evaluated at the texel's centre.
    vec3 dx = dFdx(vec3(uv, distance_m)), dy = dFdy(vec3(uv, distance_m));
    float determinant = dx.x * dy.y - dx.y * dy.x;
    vec2 gradient = vec2(dy.y * dx.z - dx.y * dy.z, dx.x * dy.z - dy.x * dx.z) / (abs(determinant) > 1e-20 ? determinant : 1e20);
    float steepest = params.max_slope * texel_m * 0.70710678;
    compared_m += clamp(dot(gradient, center - uv), -steepest, steepest);
#elif BIAS == BIAS_ADAPTIVE
    // Dou et al. 2014: the light's ray through the texel's centre against the receiver's tangent plane.
    float steepest = params.max_slope * texel_m * 0.70710678;
    float plane_m = lightViewPlaneDistance(view, center, p_world, n_world, distance_m);
    compared_m += clamp(plane_m - distance_m, -steepest, steepest);
#endif
    compared_m -= params.constant_bias * texel_m + lightViewPrecision(view, distance_m);

    // Outside the map nothing casts.
    if (any(lessThan(uv, vec2(0.0))) || any(greaterThanEqual(uv, vec2(1.0)))) return 1.0;
    float reference = clamp(lightViewDepth(view, compared_m), 0.0, 1.0);
#if LIGHT_VIEWS == 1
    return texture(t_map, vec3(center, reference));
#else
    return texture(t_map, vec4(center, float(view), reference));
#endif
}
