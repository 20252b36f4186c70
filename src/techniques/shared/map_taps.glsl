// SPDX-License-Identifier: MIT
// What to compare with many texels about one point: the tangent plane's depth in a light's map is linear over the map, (far - d)/(far - near) and
// near/d alike, so the plane is met once for the point and each texel costs two products. Include shared/map_point.glsl first.

struct MapTaps {
    float base;      // depth to compare at the point itself
    vec2 gradient;   // its change by a texel along each axis of the map
    vec2 aside;      // and by a texel away from the point on either side: towards the light
    vec2 towards;    // the same by a texel to where the normal points, if that is more
    float least, most;   // the plane is followed no farther and no nearer than the steepest slope goes
};

// `reach` in texels, as for mapPoint().
MapTaps mapTaps(MapPoint at, float reach, float perResolution) {
    float near_m = VIEW_FORWARD(at.view).w;
    float perMetre = LIGHT_PERSPECTIVE != 0 ? -near_m / (at.distance_m * at.distance_m) : -VIEW_SCALES(at.view).z;
    MapTaps taps;
#if BIAS == BIAS_ADAPTIVE || BIAS == BIAS_RECEIVER_PLANE
    taps.base = lightViewDepth(at.view, at.distance_m - params.constant_bias * at.texel_m - lightViewPrecision(at.view, at.distance_m));
#else
    taps.base = lightViewDepth(at.view, mapDistance(at, at.uv, vec2(0.5)));
#endif
    taps.gradient = taps.aside = taps.towards = vec2(0.0);
#if BIAS == BIAS_ADAPTIVE
    // Dou et al. 2014, for all texels at once. With n the normal and h the half extents, d n.forward + n.lateral(uv) is the same all over a sun's
    // plane, and (n.forward + n.lateral(uv)) d all over that of a lamp.
    vec2 rise = vec2(dot(at.n_world, VIEW_RIGHT(at.view).xyz) * VIEW_RIGHT(at.view).w, dot(at.n_world, VIEW_UP(at.view).xyz) * VIEW_UP(at.view).w);
    rise *= 2.0 * perResolution;
    float facing = LIGHT_PERSPECTIVE != 0 ? dot(at.n_world, VIEW_ORIGIN(at.view).xyz - at.p_world) : -dot(at.n_world, VIEW_FORWARD(at.view).xyz);
    // Metres by a texel, which is d^2 times the change of 1/d. Planes along the light's rays keep finite.
    if (LIGHT_PERSPECTIVE != 0) rise *= at.distance_m * at.distance_m;
    taps.gradient = perMetre * rise / max(facing, 1e-5 * (abs(rise.x) + abs(rise.y)) / at.texel_m);
#elif BIAS == BIAS_RECEIVER_PLANE
    taps.gradient = perMetre * at.gradient * perResolution;
#elif BIAS == BIAS_SLOPE
    taps.aside = vec2(-perMetre * at.slope * at.texel_m);
#elif BIAS == BIAS_ORIENTED
    vec3 n_light = vec3(dot(at.n_world, VIEW_RIGHT(at.view).xyz), dot(at.n_world, VIEW_UP(at.view).xyz), dot(at.n_world, VIEW_FORWARD(at.view).xyz));
    taps.aside = -perMetre * at.texel_m * min(abs(n_light.xy) / max(abs(n_light.z), 1e-4), params.max_slope);
#endif
    taps.least = 0.0;
    taps.most = 1.0;
#if BIAS == BIAS_ADAPTIVE || BIAS == BIAS_RECEIVER_PLANE
    float farthest_m = params.max_slope * at.texel_m * max(reach, 1.0), here = lightViewDepth(at.view, at.distance_m);
    taps.least = max(taps.base - here + lightViewDepth(at.view, at.distance_m + farthest_m), 0.0);
    taps.most = taps.base - here + lightViewDepth(at.view, at.distance_m - farthest_m);
#endif
    return taps;
}

// As much more bias as a corner of two surfaces (mapCorner()) needs, so that walls do not darken floors. One that faces the light begins where the receiver's normal points in the
// map, and there all of it is borne; elsewhere corners may be oblique to the light, and at most `steepest` is. `share` of both: 0 where the point
// itself is in the shadow, for what touches a surface looks the same and would lose its shadow.
void allowCorner(inout MapTaps taps, MapPoint at, float reach, float steepest, float share) {
    float texel = at.texel_m * (LIGHT_PERSPECTIVE != 0 ? VIEW_FORWARD(at.view).w / (at.distance_m * at.distance_m) : VIEW_SCALES(at.view).z);
#if BIAS == BIAS_ADAPTIVE || BIAS == BIAS_RECEIVER_PLANE
    float slope = length(taps.gradient) / texel;
#else
    float slope = at.slope;
#endif
    float corner = mapCorner(slope, steepest) * texel * share;
    taps.aside += corner;
    vec2 lateral = vec2(dot(at.n_world, VIEW_RIGHT(at.view).xyz), dot(at.n_world, VIEW_UP(at.view).xyz));
    float facing = mapCorner(slope, params.max_slope) * texel * share;
    taps.towards = lateral / max(length(lateral), 1e-4) * facing;
    taps.most += max(corner, facing) * (2.0 * reach + 1.0);
}

// Texels nearer than half a one are the point's own.
vec2 mapAside(vec2 offset) {
    vec2 texels = abs(offset);
    return vec2(texels.x > 0.5 ? texels.x : 0.0, texels.y > 0.5 ? texels.y : 0.0);
}

// Depth to compare with a texel whose centre is `offset` texels from the point.
float mapTap(MapTaps taps, vec2 offset) {
    float nearer = max(dot(taps.aside, mapAside(offset)), dot(taps.towards, offset));
    return clamp(taps.base + dot(taps.gradient, offset) + nearer, taps.least, taps.most);
}

// Four texels at once, of two columns and two rows, in the order of textureGather.
vec4 mapTaps4(MapTaps taps, vec2 columns, vec2 rows) {
    vec2 x = taps.gradient.x * columns, y = taps.gradient.y * rows + taps.base;
    vec2 asideX = taps.aside.x * mapAside(columns), asideY = taps.aside.y * mapAside(rows);
    vec2 towardsX = taps.towards.x * columns, towardsY = taps.towards.y * rows;
    vec4 nearer = max(asideX.xyyx + asideY.yyxx, towardsX.xyyx + towardsY.yyxx);
    return clamp(x.xyyx + y.yyxx + nearer, taps.least, taps.most);
}

// One depth for four texels that meet in a corner `offset` texels from the point: each lies half a texel aside along both axes, where the plane
// may be nearer to the light by half of its gradient along each.
float mapTapOfFour(MapTaps taps, vec2 offset) {
    float nearer = 0.5 * (abs(taps.gradient.x) + abs(taps.gradient.y));
    float corner = max(dot(taps.aside, abs(offset) + 0.5), dot(taps.towards, offset) + 0.5 * (abs(taps.towards.x) + abs(taps.towards.y)));
    return clamp(taps.base + nearer + dot(taps.gradient, offset) + corner, taps.least, min(taps.most, 1.0));
}
