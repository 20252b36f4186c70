// SPDX-License-Identifier: MIT
// One comparison with the nearest texel of a light's map, after the chosen bias. Include the technique's params first.
#include "shared/map_point.glsl"
#include "shared/map_texel.glsl"

float mapNearest(vec3 p_world, vec3 n_world) {
    float resolution = float(textureSize(t_map, 0).x), perResolution = 1.0 / resolution;
    MapPoint at;
    if (!mapPoint(p_world, n_world, 0.0, perResolution, at)) return 1.0;

    // The map's answer belongs to the centre of the nearest texel.
    vec2 texel = floor(at.uv * resolution);
    float reference = mapReference(at, (texel + 0.5) * perResolution, vec2(0.5));
    // Outside the map nothing casts.
    if (any(lessThan(at.uv, vec2(0.0))) || any(greaterThanEqual(at.uv, vec2(1.0)))) return 1.0;
    float stored = mapTexel(at.view, ivec2(texel));
    if (reference >= stored) return 1.0;
#if EXTRAPOLATE == 1
    return mapPlaneIsBehind(at, at.uv * resolution, ivec2(texel), stored) ? 1.0 : 0.0;
#else
    return 0.0;
#endif
}
