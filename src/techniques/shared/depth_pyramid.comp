// SPDX-License-Identifier: MIT
// A level of a DepthPyramid: the nearest and the farthest of what two by two texels below it hold, or of three where an odd size leaves one
// over. OF_MAP: from the map itself; LAYERED: all of its layers.
#include "shared/depth_pyramid_levels.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

#if LAYERED
layout(binding = 5) uniform sampler2DArray t_below;
layout(rg32f, binding = 0) writeonly uniform image2DArray i_levels;
#define AT(texel) ivec3(texel, int(gl_GlobalInvocationID.z))
#else
layout(binding = 5) uniform sampler2D t_below;
layout(rg32f, binding = 0) writeonly uniform image2D i_levels;
#define AT(texel) (texel)
#endif

uniform int u_level;

void main() {
    int first = imageSize(i_levels).y, width = pyramidWidth(first, u_level);
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, ivec2(width)))) return;
#if OF_MAP
    int below = textureSize(t_below, 0).x;
    ivec2 corner = ivec2(0);
#else
    int below = pyramidWidth(first, u_level - 1);
    ivec2 corner = pyramidCorner(first, u_level - 1);
#endif
    ivec2 last = min(texel * 2 + 1 + ivec2(equal(texel, ivec2(width - 1))) * (below & 1), ivec2(below - 1));
    // Depth is reversed: the nearest is the greatest.
    float nearest = 0.0, farthest = 1.0;
    for (int y = texel.y * 2; y <= last.y; ++y)
        for (int x = texel.x * 2; x <= last.x; ++x) {
            vec2 stored = texelFetch(t_below, AT(corner + ivec2(x, y)), 0).rg;
#if OF_MAP
            stored.g = stored.r;
#endif
            nearest = max(nearest, stored.r);
            farthest = min(farthest, stored.g);
        }
    imageStore(i_levels, AT(pyramidCorner(first, u_level) + texel), vec4(nearest, farthest, 0.0, 0.0));
}
