// SPDX-License-Identifier: MIT
// Which of the texels below one of ViewDepths it repeats: by a rotated grid, so that lines along rows and columns do not vanish from it.
ivec2 finerViewDepth(ivec2 texel) { return 2 * texel + ivec2(texel.y & 1, texel.x & 1); }

// The pixel of the picture whose depth a level's texel holds.
ivec2 viewDepthPixel(ivec2 texel, int level) {
    for (; level > 0; --level) texel = finerViewDepth(texel);
    return texel;
}
