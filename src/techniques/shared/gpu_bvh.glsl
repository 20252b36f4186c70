// SPDX-License-Identifier: MIT
// Rays through the scene's triangles: a threaded bounding volume hierarchy in a storage buffer (GpuBvh packs and binds it).
#include "shared/ray_triangles.glsl"

layout(std430, binding = 3) readonly buffer BvhNodes { uvec4 b_bvhNodes[]; };  // bits of lower, skip; bits of upper, leaf

uniform uint u_bvhNodeCount;

// Whether anything lies between the origin and tMax along the unit direction d.
bool occluded(RayOrigin o, vec3 d, float tMax) {
    // Components of 0 would give 0 * infinity on a box's face.
    vec3 safe = mix(d, vec3(1e-20), lessThan(abs(d), vec3(1e-20)));
    vec3 inverse = 1.0 / safe;
    // A walk through nodes of 0 would never end: nothing is asked where the origin is not real.
    uint i = o.isReal ? 0u : u_bvhNodeCount;
    while (i < u_bvhNodeCount) {
        // Down to the next leaf first, so that neighbouring rays test triangles together (Aila and Laine 2009, "while-while";
        // with one loop llvmpipe took twice as long).
        uint leaf = 0u;
        while (leaf == 0u && i < u_bvhNodeCount) {
            uvec4 lower = b_bvhNodes[2u * i], upper = b_bvhNodes[2u * i + 1u];
            vec3 t0 = (uintBitsToFloat(lower.xyz) - o.p_world) * inverse, t1 = (uintBitsToFloat(upper.xyz) - o.p_world) * inverse;
            vec3 entry = min(t0, t1), leave = max(t0, t1);
            float near = max(max(entry.x, entry.y), max(entry.z, 0.0));
            // The far side a little farther than rounding can bring it nearer (Ize 2013, 1 + 2 gamma(3)).
            float far = min(min(leave.x, leave.y), min(leave.z, tMax)) * 1.0000008;
            bool isMet = near <= far;
            leaf = isMet ? upper.w : 0u;
            i = isMet && leaf == 0u ? i + 1u : lower.w;
        }
        uint end = (leaf >> 4) + (leaf & 15u);
        for (uint slot = leaf >> 4; slot < end; ++slot)
            if (stopsAt(slot, o, d, tMax)) return true;
    }
    return false;
}
