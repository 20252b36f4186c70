// SPDX-License-Identifier: MIT
// Notes, for every cell of a grid over the light's rays, the nearest and the farthest visible point that faces the light.
// GRID: cells along an edge. From the light a point counts by its distance, under a sun by how far it lies along the rays.
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"
#include "ombrage/light.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(std430, binding = 11) buffer Cells { uint b_cells[]; };   // per cell: nearest, farthest, as bits of a float

uniform vec4 u_toward;     // towards the light: (position, 1), or (direction to the sun, 0)
uniform vec3 u_right;      // of a sun's grid
uniform vec3 u_up;
uniform vec2 u_lower;
uniform vec2 u_cellsPerMetre;
uniform float u_start;     // where distances along a sun's rays begin

const int kBlock = 8;              // pixels along an edge of a thread's share
const float kFacingAway = -0.01;   // cosine; the G-buffer rounds its normals

// Faces of a cube, as in shared/light_views.glsl.
int cellAround(vec3 d) {
    vec3 a = abs(d);
    int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    int face = axis * 2 + (d[axis] >= 0.0 ? 0 : 1);
    vec2 uv = vec2(d[(axis + 1) % 3], d[(axis + 2) % 3]) / a[axis] * 0.5 + 0.5;
    ivec2 cell = clamp(ivec2(uv * float(GRID)), 0, GRID - 1);
    return (face * GRID + cell.y) * GRID + cell.x;
}

int cellUnderSun(vec3 p_world) {
    vec2 at = (vec2(dot(p_world, u_right), dot(p_world, u_up)) - u_lower) * u_cellsPerMetre;
    ivec2 cell = clamp(ivec2(at), 0, GRID - 1);
    return cell.y * GRID + cell.x;
}

void note(int cell, vec2 range) {
    if (cell < 0) return;
    atomicMin(b_cells[cell * 2], floatBitsToUint(range.x));
    atomicMax(b_cells[cell * 2 + 1], floatBitsToUint(range.y));
}

void main() {
    ivec2 first = ivec2(gl_GlobalInvocationID.xy) * kBlock;
    ivec2 end = min(first + kBlock, ivec2(frame.viewport.xy));
    // Neighbours mostly share a cell: one note for each run of them.
    int cell = -1;
    vec2 range = vec2(0.0);
    for (int y = first.y; y < end.y; ++y)
        for (int x = first.x; x < end.x; ++x) {
            float depth = gbufferDepth(ivec2(x, y));
            if (depth == 0.0) continue;
            vec2 uv = (vec2(x, y) + 0.5) * frame.viewport.zw;
            vec3 p_world = (frame.worldFromView * vec4(positionViewFromDepth(uv, depth), 1.0)).xyz;
            vec3 toLight = u_toward.xyz - p_world * u_toward.w;
            float distance_m = length(toLight);
            // Where nothing lights up no shadow is missed.
            if (dot(gbufferGeometricNormal(ivec2(x, y)), toLight) < kFacingAway * distance_m) continue;
            if (u_toward.w == 0.0)
                distance_m = max(-dot(p_world, u_toward.xyz) - u_start, 0.0);
            else if (distance_m > light.direction.w)
                continue;
            int here = u_toward.w == 0.0 ? cellUnderSun(p_world) : cellAround(-toLight);
            if (here != cell) {
                note(cell, range);
                cell = here;
                range = vec2(distance_m);
            }
            range = vec2(min(range.x, distance_m), max(range.y, distance_m));
        }
    note(cell, range);
}
