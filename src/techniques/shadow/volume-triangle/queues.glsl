// SPDX-License-Identifier: MIT
// Work that one pass leaves to the next: a triangle's volume and a node, or a pixel, that it may hold.
#include "shadow/volume-triangle/nodes.glsl"

// One queue per level of nodes, numbered as they are, and QUEUE_EXACT for pixels. Nodes of a level are read while those of the level
// below are written, so two places are enough.
#define QUEUE_EXACT 0u
layout(std430, binding = 3) buffer VolumeQueues { uvec2 b_queues[]; };

uniform uint u_queueSize;   // of a queue of nodes
uniform uint u_exactSize;

uint roomOf(uint queue) { return queue == QUEUE_EXACT ? u_exactSize : u_queueSize; }
uint startOf(uint queue) { return u_queueSize * (queue == QUEUE_EXACT ? 2u : queue & 1u); }

// What finds no room is counted all the same: the host then asks again with fewer triangles.
void append(uint queue, uint caster, ivec2 at) {
    uint place = atomicAdd(b_nodes[QUEUES + 4u * queue], 1u);
    if (place >= roomOf(queue)) return;
    b_queues[startOf(queue) + place] = uvec2(caster, uint(at.x) | uint(at.y) << 16);
    if ((place & 63u) == 0u && (place >> 6) < 65535u) atomicAdd(b_nodes[QUEUES + 4u * queue + 1u], 1u);
}

uint lengthOf(uint queue) { return min(b_nodes[QUEUES + 4u * queue], roomOf(queue)); }
uvec2 pairAt(uint queue, uint place) { return b_queues[startOf(queue) + place]; }
ivec2 placeOf(uvec2 pair) { return ivec2(pair.y & 0xffffu, pair.y >> 16); }
