// SPDX-License-Identifier: MIT
// By how much a disk of points is turned at a pixel, by the technique's parameter `rotation` (DiskRotation in techniques/shared/disks.h).
// Include the technique's params first, and define TURN_BINDING, the unit of blueNoiseTexture().
#if ROTATION == ROTATION_BLUE_NOISE
layout(binding = TURN_BINDING) uniform sampler2D t_blueNoise;   // [0,1), tiles
#endif

// Of a turn, [0,1).
float turnOf(vec2 px) {
#if ROTATION == ROTATION_INTERLEAVED
    return fract(52.9829189 * fract(dot(px, vec2(0.06711056, 0.00583715))));   // Jimenez 2014
#elif ROTATION == ROTATION_BLUE_NOISE
    return texelFetch(t_blueNoise, ivec2(px) & (textureSize(t_blueNoise, 0) - 1), 0).r;
#else
    return 0.0;
#endif
}
