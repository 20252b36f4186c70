// SPDX-License-Identifier: MIT
// Sides and caps of volumes, to look at.
layout(location = 0) out vec4 o_color;

void main() {
#ifdef EDGE
    o_color = vec4(0.9, 0.55, 0.1, 1.0);
#elif defined(LIGHT_CAP)
    o_color = vec4(0.5, 0.35, 0.0, 0.0);
#elif defined(DARK_CAP)
    o_color = vec4(0.0, 0.08, 0.3, 0.0);
#else
    // Front faces reddish, back faces bluish: where a volume is entered and where it is left. Outlines in the same hues, so that
    // they say so too where they lie close.
#ifdef OUTLINE
    o_color = gl_FrontFacing ? vec4(0.35, 0.07, 0.0, 0.0) : vec4(0.0, 0.10, 0.35, 0.0);
#else
    o_color = gl_FrontFacing ? vec4(0.08, 0.008, 0.0, 0.0) : vec4(0.0, 0.012, 0.08, 0.0);
#endif
#endif
}
