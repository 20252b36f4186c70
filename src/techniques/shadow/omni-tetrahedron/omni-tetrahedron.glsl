// SPDX-License-Identifier: MIT
// One comparison with the nearest texel, as shadow/map.
#include "shadow/omni-tetrahedron/params"
#include "shared/map_nearest.glsl"

float shadowVisibility(vec3 p_world, vec3 n_world) { return mapNearest(p_world, n_world); }
