// SPDX-License-Identifier: MIT
// One comparison with the nearest texel of the light's map, after the chosen bias.
#include "shadow/map/params"
#include "shared/map_point.glsl"

#if LIGHT_VIEWS == 1
layout(binding = 5) uniform sampler2DShadow t_map;
#else
layout(binding = 5) uniform sampler2DArrayShadow t_map;
#endif

float shadowVisibility(vec3 p_world, vec3 n_world) {
    float resolution = float(textureSize(t_map, 0).x), perResolution = 1.0 / resolution;
    MapPoint at;
    if (!mapPoint(p_world, n_world, 0.0, perResolution, at)) return 1.0;

    // The map's answer belongs to the centre of the nearest texel.
    vec2 center = (floor(at.uv * resolution) + 0.5) * perResolution;
    float reference = mapReference(at, center, vec2(0.5));
    // Outside the map nothing casts.
    if (any(lessThan(at.uv, vec2(0.0))) || any(greaterThanEqual(at.uv, vec2(1.0)))) return 1.0;
#if LIGHT_VIEWS == 1
    return texture(t_map, vec3(center, reference));
#else
    return texture(t_map, vec4(center, float(at.view), reference));
#endif
}
