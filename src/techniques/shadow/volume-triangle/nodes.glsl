// SPDX-License-Identifier: MIT
// The hierarchy over the picture. A node of level k covers 8^k x 8^k pixels and has 8 x 8 children (Sintorn et al. 2011, section 3,
// with 8 x 4); level 0 are the pixels, level 1 the tiles.
#include "ombrage/frame.glsl"

#define TOP_LEVEL 4
#define COUNT_ASKED 0u
#define COUNT_NODES 2u
#define COUNT_PIXELS 4u
#define COUNT_EXACT 6u
#define QUEUES 8u
#define NODES_HEADER 24u
#define ENTRY_DARK 0u    // of nodes
#define ENTRY_ASKED 0u   // of tiles
#define ENTRY_DONE 2u

// Four counters of 64 bits; of four queues what they were given, and the groups of 64 that take it from there; then four words
// per node from level 1 on: two with a bit per child that lies in shadow as a whole (of a tile: per pixel that the light may
// reach), two with a bit per child of which nothing is left to ask.
layout(std430, binding = 0) coherent buffer VolumeNodes { uint b_nodes[]; };

ivec2 gridOf(int level) { return (ivec2(frame.viewport.xy) + ((1 << 3 * level) - 1)) >> (3 * level); }

uint entryOf(int level, ivec2 node) {
    uint before = 0u;
    for (int l = 1; l < level; ++l) before += uint(gridOf(l).x * gridOf(l).y);
    return NODES_HEADER + 4u * (before + uint(node.y * gridOf(level).x + node.x));
}

// Takes the first of 64 bits away and gives its index. Some bit must be set.
uint takeFirst(inout uvec2 bits) {
    bool upper = bits.x == 0u;
    uint index = uint(findLSB(upper ? bits.y : bits.x)) + (upper ? 32u : 0u);
    // Of a word of 0 nothing is taken.
    bits = uvec2(bits.x & (bits.x - 1u), upper ? bits.y & (bits.y - 1u) : bits.y);
    return index;
}

bool isAny(uvec2 bits) { return (bits.x | bits.y) != 0u; }
uvec2 bitOf(uint index) { return index < 32u ? uvec2(1u << index, 0u) : uvec2(0u, 1u << (index & 31u)); }

ivec2 childAt(ivec2 node, uint index) { return node * 8 + ivec2(index & 7u, index >> 3); }
uint indexOf(ivec2 child) { return uint((child.y & 7) * 8 + (child.x & 7)); }

void count(uint counter, uint amount) {
    uint before = atomicAdd(b_nodes[counter], amount);
    if (before + amount < before) atomicAdd(b_nodes[counter + 1u], 1u);
}

// A bit of a child, in the ENTRY_ words of its node, which is of this level.
bool isMarked(int level, ivec2 child, uint words) {
    uint index = indexOf(child);
    return (b_nodes[entryOf(level, child >> 3) + words + (index >> 5)] >> (index & 31u) & 1u) != 0u;
}

// Whether a volume, or several together, hold the node as a whole.
bool isDone(int level, ivec2 node) { return SKIP_DARK != 0 && level < TOP_LEVEL && isMarked(level + 1, node, ENTRY_DONE); }

// Children of a node have nothing left to ask; what then is true of the node itself.
void markDone(int level, ivec2 node, uvec2 children) {
    bool isWhole = true;
    for (; isWhole && level <= TOP_LEVEL; ++level) {
        uint entry = entryOf(level, node) + ENTRY_DONE;
        uvec2 now = uvec2(atomicOr(b_nodes[entry], children.x), atomicOr(b_nodes[entry + 1u], children.y)) | children;
#if SKIP_DARK
        isWhole = now == uvec2(~0u);
#else
        isWhole = false;
#endif
        children = bitOf(indexOf(node));
        node >>= 3;
    }
}
