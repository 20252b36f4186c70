// SPDX-License-Identifier: MIT
// Corners of shadow volumes: w is 1 for a corner of the caster and 0 for the same corner at the far end.
// EXTRUSION also hands over the weight of the far end: 0 at the caster, 1 at the far end.
#define POSITION_TYPE vec4
#include "ombrage/vertex.glsl"
#include "shared/volume_ends.glsl"
#ifdef TILE_BOUNDS
out float v_isNear;
#elif defined(ONTO_TILES)
#include "shared/volume_tiles.glsl"
#endif

#ifdef EXTRUSION
out float v_extrusion;
#endif

void main() {
#ifdef EXTRUSION
    v_extrusion = a_position.w == 0.0 ? 1.0 : 0.0;
#endif
    vec3 p_world = positionWorld(a_position.xyz);
    vec4 p = a_position.w == 0.0 ? farEnd(p_world, a_instance) : nearEnd(p_world, a_instance);
    gl_Position = clipFromPosition(frame.clipFromWorld, p);
#ifdef ONTO_NEAR_PLANE
    gl_Position = ontoNearPlane(gl_Position);
#elif defined(TILE_BOUNDS)
    v_isNear = a_position.w;
#elif defined(ONTO_TILES)
    gl_Position = ontoTiles(gl_Position);
#endif
}
