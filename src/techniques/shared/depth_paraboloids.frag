// SPDX-License-Identifier: MIT
// The depth of the caster's own plane at the texel's centre: exact, though the outline consists of short straight lines.
#include "shared/light_views.glsl"
#ifdef ALPHA_MASK
#include "ombrage/alpha.glsl"
in vec2 v_uv;
flat in uint v_instance;
#endif

uniform float u_perResolution;
flat in vec3 v_plane;
flat in vec2 v_depths;
flat in int v_view;

void main() {
#ifdef ALPHA_MASK
    if (isHole(b_instances[v_instance].material, v_uv)) discard;
#endif
    vec3 ray = lightViewParaboloidRay(v_view, gl_FragCoord.xy * u_perResolution);
    // Texels just outside of a piece that is seen nearly edge-on would meet its plane anywhere.
    gl_FragDepth = min(VIEW_FORWARD(v_view).w * clamp(dot(v_plane, ray), v_depths.x, v_depths.y), 1.0);
}
