// SPDX-License-Identifier: MIT
// The picture from its parts.
#include "ombrage/frame.glsl"
#include "shared/ao_parts.glsl"

layout(binding = 7) uniform sampler2D t_parts;

layout(location = 0) out vec4 o_value;

void main() { o_value = texelFetch(t_parts, aoPartOfPixel(ivec2(gl_FragCoord.xy)), 0); }
