// SPDX-License-Identifier: MIT
#ifdef ALPHA_MASK
#include "ombrage/alpha.glsl"

in vec2 v_uv;
flat in uint v_instance;

void main() {
    if (isHole(b_instances[v_instance].material, v_uv)) discard;
}
#else
void main() {}
#endif
