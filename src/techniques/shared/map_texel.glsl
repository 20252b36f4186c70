// SPDX-License-Identifier: MIT
// Texels of a light's map (LightDepth::setPlain()) and the surfaces that they show. Include shared/map_point.glsl first.
#if LIGHT_VIEWS == 1
layout(binding = 5) uniform sampler2D t_map;
#else
layout(binding = 5) uniform sampler2DArray t_map;
#endif

// Those beyond the border are as the ones at it.
float mapTexel(int view, ivec2 texel) {
    texel = clamp(texel, ivec2(0), textureSize(t_map, 0).xy - 1);
#if LIGHT_VIEWS == 1
    return texelFetch(t_map, texel, 0).r;
#else
    return texelFetch(t_map, ivec3(texel, lightViewLayer(view)), 0).r;
#endif
}

// Whether the surface that a texel shows, continued as a plane to the point at `px` (in texels, within this one), lies behind the
// point there, and so does not shade it. Depths of a plane are linear over the map, near/d and orthographic ones alike: along each axis
// the next texel, away from the point, gives the slope and one more whether they are of one plane. Where they are not, the answer is no.
bool mapPlaneIsBehind(MapPoint at, vec2 px, ivec2 texel, float stored) {
    vec2 aside = px - (vec2(texel) + 0.5);
    ivec2 away = ivec2(aside.x > 0.0 ? -1 : 1, aside.y > 0.0 ? -1 : 1);
    vec2 first = vec2(mapTexel(at.view, texel + ivec2(away.x, 0)), mapTexel(at.view, texel + ivec2(0, away.y)));
    vec2 second = vec2(mapTexel(at.view, texel + ivec2(2 * away.x, 0)), mapTexel(at.view, texel + ivec2(0, 2 * away.y)));
    vec2 rise = stored - first, bend = abs(rise - (first - second));
    float unit = mapDepthUnit(stored);
    if (any(greaterThan(bend, 0.1 * abs(rise) + 4.0 * unit))) return false;
    // Of the bias for what lies between texels only that for rounding is left.
    float own_m = at.distance_m - 0.2 * params.constant_bias * at.texel_m - lightViewPrecision(at.view, at.distance_m);
    return lightViewDepth(at.view, own_m) >= stored + dot(abs(aside), rise);
}
