// SPDX-License-Identifier: MIT
// Adds up to how often a pixel is drawn.
layout(location = 0) out float o_count;

void main() { o_count = 1.0; }
