// SPDX-License-Identifier: MIT
// Level 1 of the hierarchy: the points of a tile's pixels that the light may reach, and their bounds.
#include "ombrage/gbuffer.glsl"
#include "shared/light_sampling.glsl"
#include "shared/ray_triangles.glsl"
#include "shadow/volume-triangle/bounds.glsl"
#include "shadow/volume-triangle/nodes.glsl"

layout(local_size_x = 64) in;

layout(rgba32ui, binding = 0) writeonly uniform uimage2D i_receivers;   // bits of the position; place of the triangle
layout(rgba32f, binding = 1) writeonly uniform image2DArray i_boxes;    // layers: lower and triangle, upper

shared uint s_asked[2];

void main() {
    uint lane = gl_LocalInvocationIndex;
    ivec2 tile = ivec2(gl_WorkGroupID.xy), px = childAt(tile, lane);
    clearBounds();
    if (lane < 2u) s_asked[lane] = 0u;
    barrier();

    // Pixels of the sky, turned away from the light or out of its reach ask nothing.
    if (all(lessThan(px, ivec2(frame.viewport.xy))) && gbufferDepth(px) != 0.0) {
        RayOrigin o = rayOriginOfPixel(px, gbufferTriangle(px));
        if (o.isReal && reachesCentre(o.n_g, lightCentre(o.p_world))) {
            growBounds(o.p_world, o.p_world);
            growTriangles(triangleFromPlace(o.slot));
            atomicOr(s_asked[lane >> 5], 1u << (lane & 31u));
            imageStore(i_receivers, px, uvec4(floatBitsToUint(o.p_world), o.slot));
        }
    }
    barrier();

    if (lane == 0u) {
        imageStore(i_boxes, ivec3(tile, 0), vec4(lowerBound(), oneTriangle()));
        imageStore(i_boxes, ivec3(tile, 1), vec4(upperBound(), 0.0));
        uint entry = entryOf(1, tile);
        for (uint word = 0u; word < 2u; ++word) {
            b_nodes[entry + ENTRY_ASKED + word] = s_asked[word];
            b_nodes[entry + ENTRY_DONE + word] = ~s_asked[word];
        }
#ifdef COUNT
        count(COUNT_ASKED, uint(bitCount(s_asked[0]) + bitCount(s_asked[1])));
#endif
    }
}
