// SPDX-License-Identifier: MIT
// A depth over that of full-screen passes where a pixel shows several triangles.
layout(binding = 5) uniform usampler2D t_several;

void main() { gl_FragDepth = float(texelFetch(t_several, ivec2(gl_FragCoord.xy), 0).r); }
