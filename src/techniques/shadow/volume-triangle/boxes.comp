// SPDX-License-Identifier: MIT
// A level of the hierarchy from the one below.
#include "shadow/volume-triangle/bounds.glsl"
#include "shadow/volume-triangle/nodes.glsl"

layout(local_size_x = 64) in;

layout(binding = 6) uniform sampler2DArray t_boxes;
layout(rgba32f, binding = 1) writeonly uniform image2DArray i_boxes;

uniform int u_level;

shared uint s_empty[2];

void main() {
    uint lane = gl_LocalInvocationIndex;
    ivec2 node = ivec2(gl_WorkGroupID.xy), child = childAt(node, lane);
    clearBounds();
    if (lane < 2u) s_empty[lane] = 0u;
    barrier();

    bool isEmpty = true;
    if (all(lessThan(child, gridOf(u_level - 1)))) {
        vec4 lower = texelFetch(t_boxes, ivec3(child, 0), 3 * (u_level - 2));
        vec3 upper = texelFetch(t_boxes, ivec3(child, 1), 3 * (u_level - 2)).xyz;
        isEmpty = lower.x > upper.x;
        if (!isEmpty) {
            growBounds(lower.xyz, upper);
            growTriangles(lower.w);
        }
    }
    if (isEmpty) atomicOr(s_empty[lane >> 5], 1u << (lane & 31u));
    barrier();

    if (lane == 0u) {
        // No one asks for the box of a node of the top level.
        if (u_level < TOP_LEVEL) {
            imageStore(i_boxes, ivec3(node, 0), vec4(lowerBound(), oneTriangle()));
            imageStore(i_boxes, ivec3(node, 1), vec4(upperBound(), 0.0));
        }
        uint entry = entryOf(u_level, node);
        for (uint word = 0u; word < 2u; ++word) {
            b_nodes[entry + ENTRY_DARK + word] = 0u;
            b_nodes[entry + ENTRY_DONE + word] = s_empty[word];
        }
    }
}
