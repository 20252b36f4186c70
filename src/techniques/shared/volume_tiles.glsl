// SPDX-License-Identifier: MIT
// Volumes in a target that has one pixel for every tile of ONTO_TILES x ONTO_TILES pixels of the picture.
#include "ombrage/frame.glsl"

// The picture's size over that of its tiles, which reach beyond its right and upper border.
vec2 tilesScale() {
    vec2 tiles = ceil(frame.viewport.xy / float(ONTO_TILES));
    return frame.viewport.xy / (tiles * float(ONTO_TILES));
}

// So that the sample of a tile's pixel is the tile's middle.
vec4 ontoTiles(vec4 clip) {
    vec2 scale = tilesScale();
    return vec4(clip.xy * scale + clip.w * (scale - 1.0), clip.zw);
}

// Half a tile in the picture's coordinates, and half a pixel more than any of its samples is away from the middle.
vec2 tileReach() { return (float(ONTO_TILES) + 1.0) * frame.viewport.zw; }

vec2 tileMiddle(ivec2 tile) { return (vec2(tile) + 0.5) * float(ONTO_TILES) * 2.0 * frame.viewport.zw - 1.0; }
