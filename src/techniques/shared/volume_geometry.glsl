// SPDX-License-Identifier: MIT
// What geometry shaders of volumes emit.
#include "shared/volume_ends.glsl"
#ifdef TILE_BOUNDS
#include "shared/volume_tile_bounds.glsl"
#elif defined(ONTO_TILES)
#include "shared/volume_tiles.glsl"
#endif

in VertexData {
    vec3 p_world;
    flat uint caster;
} v_in[];

#ifdef EXTRUSION
out float v_extrusion;   // as in shared/shadow_volume.vert
#endif

vec4 farCorner(int i) { return clipFromPosition(frame.clipFromWorld, farEnd(v_in[i].p_world, v_in[i].caster)); }

void emitCorner(vec4 clip, float extrusion) {
#ifdef EXTRUSION
    v_extrusion = extrusion;
#endif
    gl_Position = clip;
#ifdef ONTO_NEAR_PLANE
    gl_Position = ontoNearPlane(clip);
#elif defined(ONTO_TILES) && !defined(TILE_BOUNDS)
    gl_Position = ontoTiles(clip);
#endif
    EmitVertex();
}

void emitNear(int i) { emitCorner(gl_in[i].gl_Position, 0.0); }

void emitFar(int i) { emitCorner(farCorner(i), 1.0); }
