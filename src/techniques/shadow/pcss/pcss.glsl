// SPDX-License-Identifier: MIT
// Percentage-closer soft shadows (Fernando 2005): the blockers near the receiver say how wide the filter is. SOFT: the light has a size.
#include "shadow/pcss/params"
#include "shared/map_point.glsl"

// What is found on the way.
struct Penumbra {
    float visibility;
    float blocker_m;      // mean distance of the blockers along the view's axis; 0 without
    float width_m;        // of the penumbra at the receiver, across the light; 0 without
    float isClipped;      // 1 where it would be wider than max-radius allows
};

const Penumbra kLit = Penumbra(1.0, 0.0, 0.0, 0.0);

#ifndef SOFT
#define EXTRAPOLATE 1
#include "shared/map_nearest.glsl"

Penumbra penumbraAt(vec3 p_world, vec3 n_world) { return Penumbra(mapNearest(p_world, n_world), 0.0, 0.0, 0.0); }
#else
#if LIGHT_VIEWS == 1
layout(binding = 5) uniform sampler2D t_map;
#define MAP_AT(uv, view) texture(t_map, uv).r
#else
layout(binding = 5) uniform sampler2DArray t_map;
#define MAP_AT(uv, view) texture(t_map, vec3(uv, float(view))).r
#endif

#define PYRAMID_BINDING 6
#include "shared/soft_light.glsl"
#define TURN_BINDING 7
#include "shared/disk_turn.glsl"

// Of the unit disk; for a rect's square the radius and the angle in turns.
uniform vec2 u_searchDisk[BLOCKER_SAMPLES];
uniform vec2 u_filterDisk[FILTER_SAMPLES];
uniform float u_maxRadius_texels;

// A point of the disk, turned, on the light's outline.
vec2 onOutline(vec2 point, vec2 turned) {
    if (LIGHT_IS(LIGHT_RECT)) {
        // From disk to square at equal areas (Shirley and Chiu 1997), side by side.
        float angle = fract(point.y + turned.x + 0.125) * 4.0;
        float side = floor(angle), along = 2.0 * (angle - side) - 1.0;
        vec2 q = point.x * (mod(side, 2.0) < 0.5 ? vec2(1.0, along) : vec2(-along, 1.0));
        return side < 1.5 ? q : -q;
    }
    return vec2(dot(point, vec2(turned.x, -turned.y)), dot(point, turned.yx));
}

// A texel of the map near the receiver.
struct Texel {
    float closer;      // than the receiver
    bool isNearer;     // to the light than the receiver's plane
    bool isBlocker;    // and between the receiver and the light
};

Texel texelAt(MapPoint at, LightInMap seen, vec2 offset_texels, float resolution, float perResolution) {
    Texel texel;
    vec2 center = (floor(at.uv * resolution + offset_texels) + 0.5) * perResolution;
    vec2 beside = (center - at.uv) * resolution;
    float compared_m = mapDistance(at, center, abs(beside));
    float closeness = closenessOfDepth(at.view, MAP_AT(center, at.view));
    texel.closer = closeness - seen.closeness;
    texel.isNearer = closeness > closenessAt(compared_m);
#if BLOCKERS == BLOCKERS_CONE
    // The nearest texel stands for what lies about the receiver, and so do those beside it within the narrowest filter; but not for the other
    // surface of a corner.
    float rise = max(abs(beside.x), abs(beside.y)) > 0.5 ? mapCorner(at.slope, params.max_slope) * length(beside) : 0.0;
    bool isAbove = closeness > closenessAt(compared_m - rise * at.texel_m);
    texel.isBlocker = texel.isNearer && isBeforeLight(seen, beside, texel.closer, isAbove ? params.min_radius : 0.0);
#else
    texel.isBlocker = texel.isNearer;
#endif
    return texel;
}

// The part of the light above the receiver's plane.
float shareAboveHorizon(LightShape shape, vec3 n_world, vec2 turned) {
    float above = 0.0;
    for (int i = 0; i < FILTER_SAMPLES; ++i) above += aboveHorizon(shape, n_world, onOutline(u_filterDisk[i], turned)) > 0.0 ? 1.0 : 0.0;
    return above / float(FILTER_SAMPLES);
}

Penumbra penumbraAt(vec3 p_world, vec3 n_world) {
    float resolution = float(textureSize(t_map, 0).x), perResolution = 1.0 / resolution;
    LightShape shape = lightShapeFrom(p_world);
    float turn = turnOf(gl_FragCoord.xy);
    vec2 turned = LIGHT_IS(LIGHT_RECT) ? vec2(turn) : vec2(cos(6.28318531 * turn), sin(6.28318531 * turn));
    Penumbra found = kLit;
    MapPoint at;
    if (!mapPoint(p_world, n_world, params.min_radius, perResolution, at)) {
        // Of surfaces that are turned away from the light's centre some may see a part of it.
        if (dot(n_world, shape.toCentre) <= 0.0) found.visibility = shareAboveHorizon(shape, n_world, turned);
        return found;
    }
    LightInMap seen = lightInMap(at, shape, resolution);
    float radius_texels = max(seen.extent_texels.x, seen.extent_texels.y), limit = u_maxRadius_texels / radius_texels;
    float least = params.min_radius / radius_texels;

    // Blocker search: the mean of how much closer to the light they are, for that is what the penumbra's width is proportional to.
    float search = max(nearestBeforeLight(at, seen, resolution, limit, params.min_radius), least);
    float blockers = 0.0, nearer = 0.0, sum = 0.0;
    for (int i = 0; i < BLOCKER_SAMPLES; ++i) {
        vec2 offset = texelsOf(seen, onOutline(u_searchDisk[i], turned), search);
        Texel texel = texelAt(at, seen, offset, resolution, perResolution);
        nearer += texel.isNearer ? 1.0 : 0.0;
        blockers += texel.isBlocker ? 1.0 : 0.0;
        sum += texel.isBlocker ? texel.closer : 0.0;
    }

    // Penumbra: wider than the map's texels, not wider than the limit.
    float closer = blockers > 0.0 ? max(sum / blockers, 0.0) : 0.0;
    found.isClipped = search >= limit ? 1.0 : 0.0;
    found.blocker_m = blockers > 0.0 ? (LIGHT_PERSPECTIVE != 0 ? 1.0 / (seen.closeness + closer) : at.distance_m - closer) : 0.0;
    found.width_m = 2.0 * closer * max(length(shape.axisX), length(shape.axisY)) * (LIGHT_PERSPECTIVE != 0 ? at.distance_m : 1.0);
    closer = clamp(closer, least, limit);

    // Filter, over the points of the light.
    int samples = blockers > 0.0 && nearer < float(BLOCKER_SAMPLES) ? FILTER_SAMPLES : 0;
    float lit = 0.0;
    for (int i = 0; i < samples; ++i) {
        vec2 u = onOutline(u_filterDisk[i], turned);
        if (aboveHorizon(shape, n_world, u) <= 0.0) continue;
        lit += texelAt(at, seen, texelsOf(seen, u, closer), resolution, perResolution).isNearer ? 0.0 : 1.0;
    }
    if (samples > 0)
        found.visibility = lit / float(FILTER_SAMPLES);
    else
        found.visibility = blockers > 0.0 ? 0.0 : shareAboveHorizon(shape, n_world, turned);
    return found;
}
#endif

float shadowVisibility(vec3 p_world, vec3 n_world) { return penumbraAt(p_world, n_world).visibility; }
