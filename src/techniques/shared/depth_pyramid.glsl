// SPDX-License-Identifier: MIT
// What a light's map holds in squares of its texels: techniques/shared/depth_pyramid.h. Include shared/light_views.glsl first, and define
// PYRAMID_BINDING.
#if LIGHT_VIEWS == 1
layout(binding = PYRAMID_BINDING) uniform sampler2D t_pyramid;
#define PYRAMID_AT(texel, view) (texel)
#else
layout(binding = PYRAMID_BINDING) uniform sampler2DArray t_pyramid;
#define PYRAMID_AT(texel, view) ivec3(texel, view)
#endif

// The nearest and the farthest (x, y; depth is reversed) of all that the map holds.
vec2 pyramidTop(int view) { return texelFetch(t_pyramid, PYRAMID_AT(ivec2(0), view), textureQueryLevels(t_pyramid) - 1).rg; }

// The same of a square of the map that holds the rectangle between two of its points, in texels, and is at most three times as wide as its
// longer side. Of what is beyond the map's border it knows nothing.
vec2 pyramidAround(int view, vec2 lower, vec2 upper) {
    // Two by two squares of the level whose squares are as wide as the rectangle, or more.
    float widest = max(max(upper.x - lower.x, upper.y - lower.y), 2.0);
    int level = clamp(int(ceil(log2(widest))) - 1, 0, textureQueryLevels(t_pyramid) - 1);
    ivec2 last = textureSize(t_pyramid, level).xy - 1;
    float perSquare = exp2(-float(level + 1));
    ivec2 from = clamp(ivec2(floor(lower * perSquare)), ivec2(0), last), to = clamp(ivec2(floor(upper * perSquare)), ivec2(0), last);
    vec2 a = texelFetch(t_pyramid, PYRAMID_AT(from, view), level).rg, b = texelFetch(t_pyramid, PYRAMID_AT(to, view), level).rg;
    vec2 c = texelFetch(t_pyramid, PYRAMID_AT(ivec2(from.x, to.y), view), level).rg;
    vec2 d = texelFetch(t_pyramid, PYRAMID_AT(ivec2(to.x, from.y), view), level).rg;
    return vec2(max(max(a.x, b.x), max(c.x, d.x)), min(min(a.y, b.y), min(c.y, d.y)));
}
