// SPDX-License-Identifier: MIT
// The whole bilateral filter (Tomasi, Manduchi 1998) over a square.
#include "filter/bilateral/params"
#include "shared/bilateral.glsl"

noperspective in vec2 v_uv;
layout(location = 0) out float o_value;

void main() {
    Bilateral b;
    if (beginBilateral(b, v_uv, params.sigma, params.plane_tolerance, params.normal_power))
        for (int y = -params.radius; y <= params.radius; ++y)
            for (int x = -params.radius; x <= params.radius; ++x) addBilateral(b, ivec2(x, y));
    o_value = b.sum / b.total;
}
