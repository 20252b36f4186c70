// SPDX-License-Identifier: MIT
// Every lane holds a volume against the pixels of a tile.
#include "shadow/volume-triangle/queues.glsl"
#include "shadow/volume-triangle/volume.glsl"

layout(local_size_x = 64) in;

layout(binding = 5) uniform sampler2D t_volumes;
layout(binding = 7) uniform usampler2D t_receivers;
#ifdef SHOW_TESTS
layout(r32ui, binding = 0) uniform uimage2D i_tests;
#endif

uniform uint u_firstCaster;
uniform float u_rayExtent_m;

void main() {
    uint place = gl_GlobalInvocationID.x;
    if (place >= lengthOf(1u)) return;
    uvec2 pair = pairAt(1u, place);
    ivec2 tile = placeOf(pair);
    uint entry = entryOf(1, tile);
#if SKIP_DARK
    uvec2 open = ~uvec2(b_nodes[entry + ENTRY_DONE], b_nodes[entry + ENTRY_DONE + 1u]);
#else
    uvec2 open = uvec2(b_nodes[entry + ENTRY_ASKED], b_nodes[entry + ENTRY_ASKED + 1u]);
#endif
    if (isDone(1, tile)) open = uvec2(0u);
    vec4 side[SIDES];
    for (int k = 0; k < SIDES; ++k) side[k] = texelFetch(t_volumes, volumeTexel(pair.x, k), 0);
    bool sure = texelFetch(t_volumes, volumeTexel(pair.x, PLANES), 0).x != 0.0;
    float margin_m = marginOf(u_rayExtent_m);
    uvec2 dark = uvec2(0u), unsure = uvec2(0u);
#ifdef COUNT
    count(COUNT_PIXELS, uint(bitCount(open.x) + bitCount(open.y)));
#endif

    while (isAny(open)) {
        uint index = takeFirst(open);
        ivec2 px = childAt(tile, index);
        uvec4 receiver = texelFetch(t_receivers, px, 0);
        vec3 p = uintBitsToFloat(receiver.xyz);
        float least_m = 3e38;
        for (int k = 0; k < SIDES; ++k) least_m = min(least_m, dot(side[k].xyz, p) + side[k].w);
        // Clear of the planes there is no doubt; else the pixel's ray decides, in a pass of its own.
        if (sure && least_m > margin_m) dark |= bitOf(index);
        else if (least_m >= -margin_m && receiver.w != u_firstCaster + pair.x) unsure |= bitOf(index);
#ifdef SHOW_TESTS
        imageAtomicAdd(i_tests, px, 1u);
#endif
    }

#ifdef COUNT
    count(COUNT_EXACT, uint(bitCount(unsure.x) + bitCount(unsure.y)));
#endif
    while (isAny(unsure)) append(QUEUE_EXACT, pair.x, childAt(tile, takeFirst(unsure)));
    if (isAny(dark)) markDone(1, tile, dark);
}
