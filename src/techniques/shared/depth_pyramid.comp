// SPDX-License-Identifier: MIT
// A level of a DepthPyramid: the nearest and the farthest of what two by two texels below it hold, or of three where an odd size leaves one
// over. OF_MAP: from the map itself; LAYERED: all of its layers.
layout(local_size_x = 8, local_size_y = 8) in;

#if LAYERED
layout(binding = 5) uniform sampler2DArray t_below;
layout(rg32f, binding = 0) writeonly uniform image2DArray i_level;
#define AT(texel) ivec3(texel, int(gl_GlobalInvocationID.z))
#else
layout(binding = 5) uniform sampler2D t_below;
layout(rg32f, binding = 0) writeonly uniform image2D i_level;
#define AT(texel) (texel)
#endif

uniform int u_level;   // of what is below

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(i_level).xy;
    if (any(greaterThanEqual(texel, size))) return;
#if OF_MAP
    int level = 0;
#else
    int level = u_level;
#endif
    ivec2 below = textureSize(t_below, level).xy;
    ivec2 last = min(texel * 2 + 1 + ivec2(equal(texel, size - 1)) * (below & 1), below - 1);
    // Depth is reversed: the nearest is the greatest.
    float nearest = 0.0, farthest = 1.0;
    for (int y = texel.y * 2; y <= last.y; ++y)
        for (int x = texel.x * 2; x <= last.x; ++x) {
            vec2 stored = texelFetch(t_below, AT(ivec2(x, y)), level).rg;
#if OF_MAP
            stored.g = stored.r;
#endif
            nearest = max(nearest, stored.r);
            farthest = min(farthest, stored.g);
        }
    imageStore(i_level, AT(texel), vec4(nearest, farthest, 0.0, 0.0));
}
