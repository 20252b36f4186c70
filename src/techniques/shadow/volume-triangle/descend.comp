// SPDX-License-Identifier: MIT
// One level down: every lane holds a volume against the children of a node. FROM_ROOTS: lanes stand for all volumes and roots, else
// for the entries of a queue.
#include "shadow/volume-triangle/queues.glsl"
#include "shadow/volume-triangle/volume.glsl"

layout(local_size_x = 64) in;

layout(binding = 5) uniform sampler2D t_volumes;
layout(binding = 6) uniform sampler2DArray t_boxes;

uniform int u_level;       // of the nodes
uniform float u_rayExtent_m;
uniform uint u_firstCaster;
#ifdef FROM_ROOTS
uniform uint u_casters;
#endif

void lookInto(uint caster, ivec2 node) {
    uint entry = entryOf(u_level, node);
    uvec2 open = ~uvec2(b_nodes[entry + ENTRY_DONE], b_nodes[entry + ENTRY_DONE + 1u]);
    if (isDone(u_level, node)) open = uvec2(0u);
    vec4 plane[SIDES + 3 * CORNER_PLANES];
    for (int k = 0; k < plane.length(); ++k) plane[k] = texelFetch(t_volumes, volumeTexel(caster, k), 0);
    bool sure = texelFetch(t_volumes, volumeTexel(caster, PLANES), 0).x != 0.0;
    float margin_m = marginOf(u_rayExtent_m);
    // No triangle shades itself: points that all lie on it are none of its business.
    float own = float(u_firstCaster + caster);
    uvec2 inside = uvec2(0u), cut = uvec2(0u);
#ifdef COUNT
    count(COUNT_NODES, uint(bitCount(open.x) + bitCount(open.y)));
#endif

    while (isAny(open)) {
        uint index = takeFirst(open);
        ivec2 child = childAt(node, index);
        vec4 lowest = texelFetch(t_boxes, ivec3(child, 0), 3 * (u_level - 2));
        vec3 highest = texelFetch(t_boxes, ivec3(child, 1), 3 * (u_level - 2)).xyz;
        vec3 centre = 0.5 * (lowest.xyz + highest), halfSize = 0.5 * (highest - lowest.xyz);
        // The least signed distances of the corners that lie farthest to the front and to the rear of each plane.
        float foremost_m = 3e38, rearmost_m = 3e38;
        for (int k = 0; k < plane.length(); ++k) {
            float distance_m = dot(plane[k].xyz, centre) + plane[k].w, reach_m = dot(abs(plane[k].xyz), halfSize);
            foremost_m = min(foremost_m, distance_m + reach_m);
            if (k < SIDES) rearmost_m = min(rearmost_m, distance_m - reach_m);
        }
        bool isInside = WHOLE_NODES != 0 && sure && rearmost_m > margin_m;
        if (isInside) inside |= bitOf(index);
        else if (foremost_m >= -margin_m && lowest.w != own) cut |= bitOf(index);
    }

    // Apart from the loop above: llvmpipe runs through all branches, and these take long.
    while (isAny(cut)) append(uint(u_level - 1), caster, childAt(node, takeFirst(cut)));
    if (isAny(inside)) {
        atomicOr(b_nodes[entry + ENTRY_DARK], inside.x);
        atomicOr(b_nodes[entry + ENTRY_DARK + 1u], inside.y);
#if SKIP_DARK
        markDone(u_level, node, inside);
#endif
    }
}

void main() {
#ifdef FROM_ROOTS
    int rootsAcross = gridOf(u_level).x, root = int(gl_GlobalInvocationID.y);
    if (gl_GlobalInvocationID.x < u_casters)
        lookInto(gl_GlobalInvocationID.x, ivec2(root % rootsAcross, root / rootsAcross));
#else
    uint place = gl_GlobalInvocationID.x;
    if (place < lengthOf(uint(u_level))) {
        uvec2 pair = pairAt(uint(u_level), place);
        lookInto(pair.x, placeOf(pair));
    }
#endif
}
