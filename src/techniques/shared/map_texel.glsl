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

// Change of depth from one texel to the next towards the point along an axis, by the two texels on the far side of `texel` or, where those
// are not of one plane with it, by the two on the point's side. False where neither are: depths of a plane are linear over the map, near/d
// and orthographic ones alike.
bool mapRise(int view, ivec2 texel, ivec2 away, float stored, float unit, out float rise) {
    float first = mapTexel(view, texel + away), second = mapTexel(view, texel + 2 * away);
    rise = stored - first;
    if (abs(rise - (first - second)) <= 0.1 * abs(rise) + unit) return true;
    first = mapTexel(view, texel - away);
    second = mapTexel(view, texel - 2 * away);
    rise = first - stored;
    return abs(rise - (second - first)) <= 0.1 * abs(rise) + unit;
}

// Whether the surface that a texel shows, continued as a plane to the point at `px` (in texels, within this one), lies behind the
// point there, and so does not shade it.
bool mapPlaneIsBehind(MapPoint at, vec2 px, ivec2 texel, float stored) {
    vec2 aside = px - (vec2(texel) + 0.5);
    float unit = 4.0 * mapDepthUnit(stored);
#ifdef LIGHT_PARABOLOIDS
    // Not linear there: twice (1 + 1) times the square of a texel, of 2 in [-1,1], for a plane that faces the light, and more for others.
    vec2 size = 2.0 / vec2(textureSize(t_map, 0).xy);
    unit += 8.0 * stored * size.x * size.x;
#endif
    vec2 rise;
    if (!mapRise(at.view, texel, ivec2(aside.x > 0.0 ? -1 : 1, 0), stored, unit, rise.x)) return false;
    if (!mapRise(at.view, texel, ivec2(0, aside.y > 0.0 ? -1 : 1), stored, unit, rise.y)) return false;
    // Of the bias for what lies between texels only that for rounding is left.
    float own_m = at.distance_m - 0.2 * params.constant_bias * at.texel_m - lightViewPrecision(at.view, at.distance_m);
    return lightViewDepth(at.view, own_m) >= stored + dot(abs(aside), rise);
}
