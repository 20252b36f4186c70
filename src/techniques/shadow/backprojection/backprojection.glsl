// SPDX-License-Identifier: MIT
// Soft shadow mapping by backprojection (Guennebaud, Barthe and Paulin 2006): texels of the map are small occluders, and each hides a part of the
// light. SOFT: the light has a size.
#include "shadow/backprojection/params"
#include "shared/map_point.glsl"

#ifndef SOFT
#define EXTRAPOLATE 1
#include "shared/map_nearest.glsl"

float lookups = 1.0;

float shadowVisibility(vec3 p_world, vec3 n_world) { return mapNearest(p_world, n_world); }
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

uniform float u_maxRadius_texels;
uniform int u_across;   // squares of each size, a multiple of 4

float lookups = 0.0;    // of shadowVisibility()

// The light's outline on the plane on which all squares are projected: the map's own axes, in texels for each unit of closeness. An ellipse
// a x^2 + 2 b x y + c y^2 <= 1, or where two strips cross.
struct Outline {
    vec3 abc;
    float discriminant;   // of the ellipse: a c - b^2
    vec2 stripX, stripY;  // -1 <= dot(strip, v) <= 1
    float top, area;
};

Outline outlineIn(LightInMap seen) {
    Outline o;
    mat2 q = seen.lightFromTexels, m = seen.texelsFromLight;
    o.abc = vec3(dot(q[0], q[0]), dot(q[0], q[1]), dot(q[1], q[1]));
    float scale = determinant(q);
    o.discriminant = scale * scale;
    o.stripX = vec2(q[0].x, q[1].x);
    o.stripY = vec2(q[0].y, q[1].y);
    o.top = LIGHT_IS(LIGHT_RECT) ? abs(m[0].y) + abs(m[1].y) : length(vec2(m[0].y, m[1].y));
    o.area = (LIGHT_IS(LIGHT_RECT) ? 4.0 : 3.14159265) / abs(scale);
    return o;
}

vec2 inStrip(vec2 strip, float y) {
    float x = abs(strip.x) > 1e-6 * abs(strip.y) ? strip.x : 1e-6 * abs(strip.y) + 1e-30;
    vec2 ends = vec2(-1.0 - strip.y * y, 1.0 - strip.y * y) / x;
    return vec2(min(ends.x, ends.y), max(ends.x, ends.y));
}

// From where to where a row is inside.
vec2 insideAt(Outline o, float y) {
    if (LIGHT_IS(LIGHT_RECT)) {
        vec2 a = inStrip(o.stripX, y), b = inStrip(o.stripY, y);
        return vec2(max(a.x, b.x), min(a.y, b.y));
    }
    float halfWidth = sqrt(max(o.abc.x - o.discriminant * y * y, 0.0));
    return vec2(-o.abc.y * y - halfWidth, -o.abc.y * y + halfWidth) / o.abc.x;
}

// Area of the outline within a rectangle: the rows' lengths, summed by Gauss's two points.
float areaWithin(Outline o, vec2 lower, vec2 upper) {
    float bottom = max(lower.y, -o.top), top = min(upper.y, o.top);
    float halfHeight = max(0.5 * (top - bottom), 0.0), middle = 0.5 * (top + bottom);
    vec2 a = insideAt(o, middle - 0.57735027 * halfHeight), b = insideAt(o, middle + 0.57735027 * halfHeight);
    float lengths = max(min(a.y, upper.x) - max(a.x, lower.x), 0.0) + max(min(b.y, upper.x) - max(b.x, lower.x), 0.0);
    return lengths * halfHeight;
}

float halfSquare(float t) { return 0.5 * max(t, 0.0) * max(t, 0.0); }

// The part of the light above the receiver's plane.
float shareAboveHorizon(LightShape shape, vec3 n_world) {
    vec2 g = abs(vec2(dot(n_world, shape.axisX), dot(n_world, shape.axisY)));
    float h = dot(n_world, shape.toCentre);
    if (LIGHT_IS(LIGHT_RECT)) {
        // Of a square on one side of a line; squares of what is far from the line would cancel each other out.
        if (abs(h) >= g.x + g.y) return h > 0.0 ? 1.0 : 0.0;
        g = max(g, 1e-3 * (g.x + g.y));
        float above = halfSquare(h + g.x + g.y) - halfSquare(h + g.x - g.y) - halfSquare(h - g.x + g.y) + halfSquare(h - g.x - g.y);
        return clamp(above / (4.0 * g.x * g.y), 0.0, 1.0);
    }
    float u = clamp(h / max(length(g), 1e-12), -1.0, 1.0);
    return 1.0 - (acos(u) - u * sqrt(max(1.0 - u * u, 0.0))) / 3.14159265;
}

// Closeness of a square of the map, 2^level texels wide: of what is nearest in it and farthest.
vec2 closenessOfSquare(MapPoint at, ivec2 square, int level, float perResolution) {
    if (level == 0) return vec2(closenessOfDepth(at.view, MAP_AT((vec2(square) + 0.5) * perResolution, at.view)));
    vec2 range = pyramidSquare(at.view, level - 1, square);
    return vec2(closenessOfDepth(at.view, range.x), closenessOfDepth(at.view, range.y));
}

// Where a place of the map is seen on the plane of the outline from the receiver, past what is so much closer to the light.
float backprojectionScale(LightInMap seen, vec2 beside, float closer) {
    float tilted = closer;
    if (!LIGHT_IS(LIGHT_SUN)) tilted += dot(seen.tilt, seen.lightFromTexels * beside);
    return 1.0 / max(tilted, 1e-3 * closer);
}

// What a square hides of the outline.
// @param isSeen by the light's centre
float hiddenBy(MapPoint at, LightInMap seen, Outline outline, bool isSeen, ivec2 square, int level, vec2 here, float perResolution) {
    float size = exp2(float(level));
    vec2 lower = vec2(square) * size - here, upper = lower + size, beside = lower + 0.5 * size;
    vec2 closeness = closenessOfSquare(at, square, level, perResolution);
    // It must be above the receiver's plane, wherever in the square that is nearest to the light; beside the texel of a receiver that the light's
    // centre sees also above the other surface of a corner.
    float compared_m = mapDistance(at, (here + beside) * perResolution, abs(beside)) - 0.70710678 * (size - 1.0) * at.slope * at.texel_m;
    float aside = max(abs(beside.x), abs(beside.y));
    if (isSeen && aside > 0.5 && aside < 1.5 && level == 0) compared_m -= mapCorner(at.slope, params.max_slope) * length(beside) * at.texel_m;
    float plane = closenessAt(compared_m);
    if (closeness.x <= plane || closeness.x <= seen.closeness) return 0.0;
    // All of a large square is as close as the middle of it; of one that is blocked in part a half is.
    bool isFull = closeness.y > plane && closeness.y > seen.closeness;
    float closer = (isFull ? 0.5 * (closeness.x + closeness.y) : closeness.x) - seen.closeness;

    float scale = backprojectionScale(seen, beside, closer);
    vec2 from = lower * scale, to = upper * scale;
#if GAPS == GAPS_CLOSED
    // Up to the edges of the squares to the left and below, so that no light comes through between them (section 3.3).
    float left = closenessOfSquare(at, square - ivec2(1, 0), level, perResolution).x;
    float below = closenessOfSquare(at, square - ivec2(0, 1), level, perResolution).x;
    if (left > plane && left > seen.closeness) from.x = min(from.x, lower.x * backprojectionScale(seen, beside, left - seen.closeness));
    if (below > plane && below > seen.closeness) from.y = min(from.y, lower.y * backprojectionScale(seen, beside, below - seen.closeness));
#endif
    return areaWithin(outline, from, to) * (isFull ? 1.0 : 0.5);
}

float shadowVisibility(vec3 p_world, vec3 n_world) {
    float resolution = float(textureSize(t_map, 0).x), perResolution = 1.0 / resolution;
    LightShape shape = lightShapeFrom(p_world);
    MapPoint at;
    if (!mapPoint(p_world, n_world, 0.5, perResolution, at))
        // Of surfaces that are turned away from the light's centre some may see a part of it.
        return dot(n_world, shape.toCentre) <= 0.0 ? shareAboveHorizon(shape, n_world) : 1.0;
    float above = shareAboveHorizon(shape, n_world);
    LightInMap seen = lightInMap(at, shape, resolution);
    float closer = nearestBeforeLight(at, seen, resolution, 1e30, 0.5);
    if (closer <= 0.0) return above;
    // A light that asks for more texels than the limit counts as a smaller one.
    float smaller = min(u_maxRadius_texels / (closer * max(seen.extent_texels.x, seen.extent_texels.y)), 1.0);
    seen.texelsFromLight *= smaller;
    seen.lightFromTexels /= smaller;
    seen.tilt *= smaller;
    seen.extent_texels *= smaller;

    // Squares of one texel about the receiver, of two around those, and so on: what is far from it in the map is before the light only if it is
    // as much closer to the light, and large squares are small there.
    Outline outline = outlineIn(seen);
    vec2 here = at.uv * resolution, reach = seen.extent_texels * closer + 0.5, center = (floor(here) + 0.5) * perResolution;
    bool isSeen = closenessAt(mapDistance(at, center, abs(center - at.uv) * resolution)) >= closenessOfDepth(at.view, MAP_AT(center, at.view));
    float hidden = 0.0;
    ivec2 innerFrom = ivec2(0), innerTo = ivec2(0);
    bool isWhole = false;
    for (int level = 0; !isWhole && hidden < outline.area; ++level) {
        float perSquare = exp2(-float(level));
        ivec2 from = 2 * ivec2(floor(here * perSquare * 0.5)) - u_across / 2, to = from + u_across;
        ivec2 least = ivec2(floor(max(here - reach, vec2(0.0)) * perSquare)), most = ivec2(floor(min(here + reach, vec2(resolution - 1.0)) * perSquare)) + 1;
        ivec2 first = max(from, least), last = min(to, most);
        for (int y = first.y; y < last.y; ++y)
            for (int x = first.x; x < last.x; ++x) {
                ivec2 square = ivec2(x, y);
                if (all(greaterThanEqual(square, innerFrom)) && all(lessThan(square, innerTo))) continue;
                hidden += hiddenBy(at, seen, outline, isSeen, square, level, here, perResolution);
                lookups += 1.0;
            }
        isWhole = all(greaterThanEqual(least, from)) && all(lessThanEqual(most, to));
        innerFrom = from / 2;
        innerTo = to / 2;
    }
    return clamp(above - hidden / outline.area, 0.0, 1.0);
}
#endif
