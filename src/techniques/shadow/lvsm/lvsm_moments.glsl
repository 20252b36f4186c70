// SPDX-License-Identifier: MIT
// Depth within a layer, stretched over [0,1], and its square (Lauritzen, McCool 2008, equation 5).
#include "shadow/lvsm/params"

uniform vec4 u_layers[LAYERS];   // z where it begins, stretched depth per z, the layer's end

float depthInLayer(float z, int layer) { return clamp((z - u_layers[layer].x) * u_layers[layer].y, 0.0, 1.0); }

vec4 momentsOf(float z, int sheet) {
    float w = depthInLayer(z, sheet);
    return vec4(w, w * w, 0.0, 0.0);
}
