// SPDX-License-Identifier: MIT
// The scene's triangles in storage buffers (GpuTriangles packs and binds them), points of surfaces that rays start from, and
// what stops a ray.
#include "ombrage/frame.glsl"

layout(std430, binding = 4) readonly buffer RayTriangles { uvec4 b_rayTriangles[]; }; // bits of a corner, global id; instance; alpha
layout(std430, binding = 5) readonly buffer RaySlots { uint b_raySlots[]; };         // per global triangle its place in b_rayTriangles
layout(std430, binding = 6) readonly buffer RayAlpha { uint b_rayAlpha[]; };         // records of holes and their bits
#if defined(EXCLUDES)
layout(std430, binding = 7) readonly buffer RayInstances { uint b_rayExcluded[]; };  // per instance: 1 lets rays through
#elif defined(SAME_MODEL)
layout(std430, binding = 7) readonly buffer RayInstances { uint b_rayModel[]; };     // per instance: rays end on their own model's
#endif

uniform float u_rayExtent_m;   // largest absolute coordinate

// The point that rays start from: the hit itself, from its triangle and in double, never from depth.
struct RayOrigin {
    dvec3 exact;
    vec3 p_world;
    vec3 n_g;     // unit, on the side seen
    uint slot;    // of the triangle it lies on, which no ray from here can hit
    bool isReal;  // false where the triangle has no area, and in lanes that no one sees, where llvmpipe reads 0 from storage
};

vec3 rayCorner(uint slot, uint corner) { return uintBitsToFloat(b_rayTriangles[3u * slot + corner].xyz); }

// Where the pixel's ray meets the plane of its triangle.
RayOrigin rayOriginOfPixel(ivec2 px, uint triangle) {
    RayOrigin o;
    o.slot = b_raySlots[triangle];
    dvec3 a = dvec3(rayCorner(o.slot, 0u)), b = dvec3(rayCorner(o.slot, 1u)), c = dvec3(rayCorner(o.slot, 2u));
    dvec3 n = cross(b - a, c - a);

    dvec2 size = dvec2(frame.viewport.xy);
    dvec2 plane = ((dvec2(px) + 0.5) / size * 2.0 - 1.0) * double(frame.projection.w) * dvec2(size.x / size.y, 1.0);
    dvec3 aside = dvec3(frame.worldFromView[0].xyz) * plane.x + dvec3(frame.worldFromView[1].xyz) * plane.y;
    dvec3 start = dvec3(frame.eye.xyz), direction = dvec3(frame.forward.xyz);
    if (isOrthographic()) start += aside;
    else direction += aside;

    o.isReal = dot(n, n) > 0.0;
    double facing = dot(n, direction);
    dvec3 p = facing == 0.0 ? a : start + direction * (dot(n, a - start) / facing);

    // The rasteriser's snapped corners give a triangle pixels whose centres lie just outside it, where the plane may run behind
    // a neighbour. The receiver is kept inside, a rounding error away from the edges, as the truth's is.
    double doubleArea = sqrt(dot(n, n));
    double inset_m = double(u_rayExtent_m) * 4.0 * 1.1920929e-7;
    dvec3 weights = dvec3(dot(n, cross(c - b, p - b)), dot(n, cross(a - c, p - c)), dot(n, cross(b - a, p - a))) / dot(n, n);
    dvec3 least = min(dvec3(length(c - b), length(c - a), length(b - a)) * (inset_m / doubleArea), dvec3(1.0 / 3.0));
    weights = max(weights, least);
    weights /= weights.x + weights.y + weights.z;
    o.exact = a + (b - a) * weights.y + (c - a) * weights.z;
    o.p_world = vec3(o.exact);
    o.n_g = normalize(vec3(n * (inversesqrt(dot(n, n)) * (facing > 0.0 ? -1.0 : 1.0))));
    return o;
}

// Holes of alpha-tested casters: one bit per texel, nearest, repeated, as ombrage/alpha.glsl has it. A record is the uv of three
// corners, the first word of its bits and its size.
bool isRayHole(uint record, vec3 weights) {
    uint at = (record - 1u) * 8u;
    vec2 uv = vec2(0.0);
    for (uint k = 0u; k < 3u; ++k)
        uv += weights[k] * vec2(uintBitsToFloat(b_rayAlpha[at + 2u * k]), uintBitsToFloat(b_rayAlpha[at + 2u * k + 1u]));
    uint size = b_rayAlpha[at + 7u];
    ivec2 extent = ivec2(int(size & 0xffffu), int(size >> 16));
    ivec2 texel = min(ivec2(fract(uv) * vec2(extent)), extent - 1);
    uint bit = uint(texel.y * extent.x + texel.x);
    return (b_rayAlpha[b_rayAlpha[at + 6u] + (bit >> 5)] >> (bit & 31u) & 1u) != 0u;
}

// The float origin may lie a rounding error behind its surface and then meets neighbours in the same plane. A second look in
// double tells them from a true blocker, however near. Errors of extent * 2^-24 are up to 50 times as long along grazing rays;
// the margin is 16.
float recheckBelow_m() { return u_rayExtent_m * 1.1920929e-7 * 800.0; }

// Whether floats see the triangle in `slot` stop the ray from p, a point of the triangle in `own`, before tMax. The edges' signs
// come from corners relative to the origin, and a shared edge gives both its triangles the same number but for the sign, so that
// no ray slips through between them (watertight as in Woop et al. 2013, here with the triple products of Davidovic et al. 2012
// instead of a shear). Where the answer is yes, isNear asks for that of meetsExactly().
bool meets(uint slot, vec3 p, uint own, vec3 d, float tMax, out bool isNear) {
    isNear = false;
    vec3 a = rayCorner(slot, 0u) - p, b = rayCorner(slot, 1u) - p, c = rayCorner(slot, 2u) - p;
    precise vec3 normalA = cross(c - b, c + b);
    precise vec3 normalB = cross(a - c, a + c);
    precise vec3 normalC = cross(b - a, b + a);
    precise vec3 weights = vec3(dot(normalA, d), dot(normalB, d), dot(normalC, d));
    float sum = weights.x + weights.y + weights.z;
    float tolerance = 1.2e-7 * abs(sum);
    float least = min(weights.x, min(weights.y, weights.z)), most = max(weights.x, max(weights.y, weights.z));
    if (least < -tolerance && most > tolerance) return false;

    vec3 n = cross(b - a, c - a);
    float along = dot(n, d);
    float t = dot(n, a) / along;
    if (along == 0.0 || !(t > 0.0 && t <= tMax) || slot == own) return false;
#if defined(EXCLUDES)
    if (b_rayExcluded[b_rayTriangles[3u * slot + 1u].w] != 0u) return false;
#elif defined(SAME_MODEL)
    if (b_rayModel[b_rayTriangles[3u * slot + 1u].w] != b_rayModel[b_rayTriangles[3u * own + 1u].w]) return false;
#endif
    uint record = b_rayTriangles[3u * slot + 2u].w;
    if (record != 0u && isRayHole(record, weights / sum)) return false;
    isNear = t < recheckBelow_m();
    return true;
}

bool meetsExactly(uint slot, dvec3 origin, vec3 d) {
    dvec3 p0 = dvec3(rayCorner(slot, 0u)), p1 = dvec3(rayCorner(slot, 1u)), p2 = dvec3(rayCorner(slot, 2u));
    dvec3 exactNormal = cross(p1 - p0, p2 - p0);
    double onPlane = double(recheckBelow_m()) * 1e-9;
    double exactT = dot(exactNormal, p0 - origin) / dot(exactNormal, dvec3(d));
    if (!(exactT > onPlane)) return false;
    // Inside to a billionth of its heights: beside a convex edge the neighbour's plane is met outside the neighbour.
    dvec3 p = origin + dvec3(d) * exactT;
    double inside = min(dot(exactNormal, cross(p2 - p1, p - p1)),
                        min(dot(exactNormal, cross(p0 - p2, p - p2)), dot(exactNormal, cross(p1 - p0, p - p0))));
    return inside >= -1e-9 * dot(exactNormal, exactNormal);
}

// Whether the triangle in `slot` stops the ray before tMax.
bool stopsAt(uint slot, RayOrigin o, vec3 d, float tMax) {
    bool isNear;
    if (!meets(slot, o.p_world, o.slot, d, tMax, isNear)) return false;
    return !isNear || meetsExactly(slot, o.exact, d);
}

// How near to a light a hit counts as the light itself: rounding errors of positions, times a few.
float rayLengthTo(float distance_m) {
    return distance_m >= 1e30 ? distance_m : max(0.0, distance_m - 4.0 * 1.1920929e-7 * (u_rayExtent_m + distance_m));
}
