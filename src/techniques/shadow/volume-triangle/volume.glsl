// SPDX-License-Identifier: MIT
// A triangle's shadow volume: planes with the volume on their positive side. 0: the triangle's own; 1 to 3: through the light and an
// edge; together they bound the volume. 4 to 6: through the light and a corner, along the opposite edge; where two edges meet at a
// sharp angle they keep out what the sides let pass.
#define SIDES 4
#define PLANES 7

// Eight texels per triangle: the planes, and in x of the last 1 where what lies in the volume by more than the margin is in shadow.
#define VOLUME_TEXELS 8
#define VOLUMES_ACROSS 128u
ivec2 volumeTexel(uint caster, int plane) {
    return ivec2(int(caster % VOLUMES_ACROSS) * VOLUME_TEXELS + plane, int(caster / VOLUMES_ACROSS));
}

// How far rounding can move a point over a plane: positions to 2^-24 of the extent, a few dozen operations on them, here and in the
// rays' own arithmetic.
float marginOf(float extent_m) { return 32.0 * 1.1920929e-7 * extent_m; }
