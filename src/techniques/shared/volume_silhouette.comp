// SPDX-License-Identifier: MIT
// Appends the indices of one caster's volume to the room of its draw commands. PART 0: the sides, a thread per pair of an
// edge's uses; PART 1: the caps, a thread per triangle. Codes are those of VolumeTriangles: vertex * 2, plus 1 for the far end.
#include "shared/volume_edges.glsl"

layout(local_size_x = 64) in;

struct Command { uint count, instances, firstIndex; int baseVertex; uint baseInstance; };
layout(std430, binding = 6) readonly buffer TriangleVertices { uint b_vertices[]; };   // three per triangle
layout(std430, binding = 8) buffer Commands { Command b_commands[]; };                 // of each part, one per caster
layout(std430, binding = 9) writeonly buffer Indices { uint b_indices[]; };

uniform uint u_caster;
uniform uint u_casters;

uint room(uint part, uint count) {
    uint command = part * u_casters + u_caster;
    return b_commands[command].firstIndex + atomicAdd(b_commands[command].count, count);
}

void put(uint at, uint a, uint b, uint c) {
    b_indices[at] = a;
    b_indices[at + 1u] = b;
    b_indices[at + 2u] = c;
}

void main() {
    uint i = gl_GlobalInvocationID.x;
    bool farEnds = (b_casters[u_caster].flags & CASTER_FAR_ENDS) != 0u;
#if PART == 0
    if (i >= b_casters[u_caster].pairs) return;
    uvec4 pair = b_pairs[b_casters[u_caster].firstPair + i];
    int count = sidesAt(u_caster, pair);
    bool turned = (count < 0) != ((b_casters[u_caster].flags & CASTER_MIRRORED) != 0u);
    uvec2 near = (b_casters[u_caster].firstVertex + (turned ? pair.yx : pair.xy)) * 2u;
    for (int k = 0; k < abs(count); ++k) {
        uint at = room(0u, farEnds ? 6u : 3u);
        put(at, near.y, near.x, near.x + 1u);
        if (farEnds) put(at + 3u, near.y, near.x + 1u, near.y + 1u);
    }
#else
    if (i >= b_casters[u_caster].triangles) return;
    int weight = weightOf(u_caster, i);
    if (weight == 0) return;
    bool outwards = facesOut(u_caster, weight);
    uint first = (b_casters[u_caster].firstTriangle + i) * 3u;
    uvec3 near = uvec3(b_vertices[first], b_vertices[first + 1u], b_vertices[first + 2u]) * 2u;
    put(room(outwards ? 1u : 3u, 3u), near.x, near.y, near.z);
    if (!farEnds) return;
    near = outwards ? near.xzy : near.xyz;
    put(room(2u, 3u), near.x + 1u, near.y + 1u, near.z + 1u);
#endif
}
