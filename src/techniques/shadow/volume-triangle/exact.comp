// SPDX-License-Identifier: MIT
// The rays of pixels that planes cannot decide, with the arithmetic of shadow/ray-traced.
#include "shared/light_sampling.glsl"
#include "shared/ray_triangles.glsl"
#include "shadow/volume-triangle/queues.glsl"

layout(local_size_x = 64) in;

layout(binding = 7) uniform usampler2D t_receivers;

uniform uint u_firstCaster;

bool isStopped(ivec2 px, uint slot) {
    uvec4 receiver = texelFetch(t_receivers, px, 0);
    vec3 p = uintBitsToFloat(receiver.xyz);
    LightSample centre = lightCentre(p);
    bool isNear;
    if (!meets(slot, p, receiver.w, centre.direction, rayLengthTo(centre.distance_m), isNear)) return false;
    // The point in double is made again for the few that need it.
    return !isNear || meetsExactly(slot, rayOriginOfPixel(px, b_rayTriangles[3u * receiver.w].w).exact, centre.direction);
}

void main() {
    uint stride = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
    for (uint place = gl_GlobalInvocationID.x; place < lengthOf(QUEUE_EXACT); place += stride) {
        uvec2 pair = pairAt(QUEUE_EXACT, place);
        ivec2 px = placeOf(pair), tile = px >> 3;
        if (isStopped(px, u_firstCaster + pair.x)) markDone(1, tile, bitOf(indexOf(px)));
    }
}
