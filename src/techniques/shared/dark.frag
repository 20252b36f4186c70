// SPDX-License-Identifier: MIT
// Visibility 0 wherever the stencil lets it through.
layout(location = 0) out float o_visibility;

void main() { o_visibility = 0.0; }
