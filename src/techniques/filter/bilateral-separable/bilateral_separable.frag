// SPDX-License-Identifier: MIT
// One direction of the separable bilateral filter (Pham, van Vliet 2005).
#include "filter/bilateral-separable/params"
#include "shared/bilateral.glsl"

uniform ivec2 u_step;   // (1,0) or (0,1)

noperspective in vec2 v_uv;
layout(location = 0) out float o_value;

void main() {
    Bilateral b;
    if (beginBilateral(b, v_uv, params.sigma, params.plane_tolerance, params.normal_power))
        for (int i = -params.radius; i <= params.radius; ++i) addBilateral(b, i * u_step);
    o_value = b.sum / b.total;
}
