// SPDX-License-Identifier: MIT
#ifdef ALPHA_MASK
#include "ombrage/alpha.glsl"
#endif
#include "shadow/planar/params"

#ifdef ALPHA_MASK
in vec2 v_uv;
flat in uint v_instance;
#endif

layout(location = 0) out float o_visibility;

void main() {
#ifdef ALPHA_MASK
    if (isHole(b_instances[v_instance].material, v_uv)) discard;
#endif
    o_visibility = 1.0 - params.opacity;
}
