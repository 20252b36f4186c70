// SPDX-License-Identifier: MIT
// The picture as 4x4 parts of every fourth pixel each, laid side by side (AoPixels::Deinterleaved in techniques/shared/screen_ao.h).
const int AO_PART_STRIDE = 4;

// Size of a part; the last row and column of some hold no pixel.
ivec2 aoPartSize() { return (ivec2(frameViewport.xy) + AO_PART_STRIDE - 1) / AO_PART_STRIDE; }

ivec2 aoPixelOfPart(ivec2 texel) {
    ivec2 size = aoPartSize();
    return (texel % size) * AO_PART_STRIDE + texel / size;
}

ivec2 aoPartOfPixel(ivec2 px) { return (px % AO_PART_STRIDE) * aoPartSize() + px / AO_PART_STRIDE; }
