// SPDX-License-Identifier: MIT
// Which triangles cast and which edges bound their volumes, as techniques/shared/silhouette.cpp has it (Bergeron 1986; Kim
// et al. 2008). Every stage asks for a triangle's side in the same words, so sides and caps agree.
#define CASTER_BOTH 1u
#define CASTER_MIRRORED 2u
#define CASTER_FAR_ENDS 4u
#define NO_USE 0xffffffffu

struct Caster {
    vec4 light_local;       // towards the light in the mesh's space
    uint firstPair, pairs;
    uint firstTriangle, triangles;
    uint firstVertex;
    float inPlane_local;    // how near to a triangle's plane the light counts as in it
    uint flags;             // CASTER_...
};

layout(std430, binding = 3) readonly buffer Casters { Caster b_casters[]; };
layout(std430, binding = 4) readonly buffer Pairs { uvec4 b_pairs[]; };     // two vertices; forward and backward use
layout(std430, binding = 5) readonly buffer Planes { vec4 b_planes[]; };

// 1: casts as it is wound, -1: turned around, 0: does not cast.
int weightOf(uint caster, uint triangle) {
    vec4 plane = b_planes[b_casters[caster].firstTriangle + triangle], light = b_casters[caster].light_local;
    precise float side = plane.x * light.x + plane.y * light.y + plane.z * light.z + plane.w * light.w;
    // Products of rounded planes: their own error on top.
    precise float doubt = b_casters[caster].inPlane_local * length(plane.xyz) + 3.6e-7 * dot(abs(plane), abs(light)) * light.w;
    if (abs(side) <= doubt) return 0;
    if (side > 0.0) return (b_casters[caster].flags & CASTER_BOTH) != 0u ? 1 : 0;
    return -1;
}

// How often the edge bounds a volume; below 0 in its backward direction.
int sidesAt(uint caster, uvec4 pair) {
    int count = 0;
    if (pair.z != NO_USE) count += weightOf(caster, pair.z >> 1);
    if (pair.w != NO_USE) count -= weightOf(caster, pair.w >> 1);
    return count;
}

// Whether the light cap of a casting triangle is counter-clockwise seen from outside the volume.
bool facesOut(uint caster, int weight) { return (weight > 0) != ((b_casters[caster].flags & CASTER_MIRRORED) != 0u); }
