// SPDX-License-Identifier: MIT
// Where the levels of a DepthPyramid stand in its texture, whose first is `first` texels wide: that at the left, the others above one another
// to its right.
int pyramidWidth(int first, int level) { return first >> level; }

ivec2 pyramidCorner(int first, int level) { return level == 0 ? ivec2(0) : ivec2(first, first - (first >> (level - 1))); }
