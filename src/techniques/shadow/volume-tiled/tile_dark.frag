// SPDX-License-Identifier: MIT
// Tiles whose count is not 0.
layout(location = 0) out vec2 o_class;   // boundary, dark

void main() { o_class = vec2(0.0, 1.0); }
