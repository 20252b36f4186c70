// SPDX-License-Identifier: MIT
// What a light's map holds in squares of its texels: techniques/shared/depth_pyramid.h. Include shared/light_views.glsl first, and define
// PYRAMID_BINDING.
#include "shared/depth_pyramid_levels.glsl"

#if LIGHT_VIEWS == 1
layout(binding = PYRAMID_BINDING) uniform sampler2D t_pyramid;
#define PYRAMID_AT(texel, view) (texel)
#else
layout(binding = PYRAMID_BINDING) uniform sampler2DArray t_pyramid;
#define PYRAMID_AT(texel, view) ivec3(texel, view)
#endif

int pyramidTopLevel() { return findMSB(textureSize(t_pyramid, 0).y); }

// The nearest and the farthest (x, y; depth is reversed) in a square of the map, one of those 2^(level + 1) texels wide; beyond the border nothing.
vec2 pyramidSquare(int view, int level, ivec2 square) {
    int first = textureSize(t_pyramid, 0).y;
    if (any(lessThan(square, ivec2(0))) || any(greaterThanEqual(square, ivec2(pyramidWidth(first, level))))) return vec2(0.0);
    return texelFetch(t_pyramid, PYRAMID_AT(pyramidCorner(first, level) + square, view), 0).rg;
}

// The same of all that the map holds.
vec2 pyramidTop(int view) { return pyramidSquare(view, pyramidTopLevel(), ivec2(0)); }

// The same of a square of the map that holds the rectangle between two of its points, in texels, and is at most three times as wide as its
// longer side; of what is beyond the map's border that nothing is there.
vec2 pyramidAround(int view, vec2 lower, vec2 upper, float resolution) {
    if (any(lessThan(upper, vec2(0.0))) || any(greaterThanEqual(lower, vec2(resolution)))) return vec2(0.0);
    bool isCut = any(lessThan(lower, vec2(0.0))) || any(greaterThan(upper, vec2(resolution)));
    lower = max(lower, vec2(0.0));
    upper = min(upper, vec2(resolution));
    // Two by two squares of the level whose squares are as wide as the rectangle, or more.
    float widest = max(max(upper.x - lower.x, upper.y - lower.y), 2.0);
    int level = clamp(int(ceil(log2(widest))) - 1, 0, pyramidTopLevel());
    ivec2 last = ivec2(pyramidWidth(textureSize(t_pyramid, 0).y, level) - 1);
    float perSquare = exp2(-float(level + 1));
    ivec2 from = min(ivec2(lower * perSquare), last), to = min(ivec2(upper * perSquare), last);
    vec2 a = pyramidSquare(view, level, from), b = pyramidSquare(view, level, to);
    vec2 c = pyramidSquare(view, level, ivec2(from.x, to.y)), d = pyramidSquare(view, level, ivec2(to.x, from.y));
    return vec2(max(max(a.x, b.x), max(c.x, d.x)), isCut ? 0.0 : min(min(a.y, b.y), min(c.y, d.y)));
}
