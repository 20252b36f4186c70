// SPDX-License-Identifier: MIT
// The planes of the shadow volumes of some casting triangles.
#include "ombrage/light.glsl"
#include "shared/ray_triangles.glsl"
#include "shadow/volume-triangle/volume.glsl"

layout(local_size_x = 64) in;

layout(rgba32f, binding = 0) writeonly uniform image2D i_volumes;

uniform uint u_firstCaster;
uniform uint u_casters;   // of this pass

// A plane that everything is behind.
const vec4 kNowhere = vec4(0.0, 0.0, 0.0, -3e38);

dvec3 towardLight(dvec3 p) {
    return light.position.w == 0.0 ? -dvec3(light.direction.xyz) : dvec3(light.position.xyz) - p;
}

vec4 planeThrough(dvec3 p, dvec3 normal, double size) {
    if (!(size > 0.0)) return vec4(0.0);
    normal /= size;
    return vec4(vec3(normal), float(-dot(normal, p)));
}

// Through the light and p, along an edge. Where both directions are one there is no plane, and nothing is behind it. In double: edges
// nearly along the light would lose the direction.
vec4 planeAlong(dvec3 edge, dvec3 p, double sign_) {
    dvec3 rayward = towardLight(p), normal = cross(edge, rayward) * sign_;
    double size = length(normal);
    return planeThrough(p, normal, size > 1e-9 * length(edge) * length(rayward) ? size : 0.0);
}

void main() {
    uint caster = gl_GlobalInvocationID.x, slot = u_firstCaster + caster;
    if (caster >= u_casters) return;
    dvec3 a = dvec3(rayCorner(slot, 0u)), b = dvec3(rayCorner(slot, 1u)), c = dvec3(rayCorner(slot, 2u));
    dvec3 n = cross(b - a, c - a);
    double area = sqrt(dot(n, n)), height = dot(n, towardLight(a));

    // A triangle that the light sees edge on, or without area, casts a line.
    bool casts = abs(height) > 1e-12 * area * length(towardLight(a));
#ifdef EXCLUDES
    if (b_rayExcluded[b_rayTriangles[3u * slot + 1u].w] != 0u) casts = false;
#endif
    // All signs follow from the side of the triangle that the light is on.
    double turn = height > 0.0 ? 1.0 : -1.0;
    imageStore(i_volumes, volumeTexel(caster, 0), casts ? planeThrough(a, n * -turn, area) : kNowhere);
    imageStore(i_volumes, volumeTexel(caster, 1), planeAlong(b - a, a, -turn));
    imageStore(i_volumes, volumeTexel(caster, 2), planeAlong(c - b, b, -turn));
    imageStore(i_volumes, volumeTexel(caster, 3), planeAlong(a - c, c, -turn));
    imageStore(i_volumes, volumeTexel(caster, 4), planeAlong(b - a, c, turn));
    imageStore(i_volumes, volumeTexel(caster, 5), planeAlong(c - b, a, turn));
    imageStore(i_volumes, volumeTexel(caster, 6), planeAlong(a - c, b, turn));

    // Triangles with holes are asked pixel by pixel, and so are those nearer to a lamp than rays are exact.
    bool sure = b_rayTriangles[3u * slot + 2u].w == 0u;
    if (light.position.w != 0.0) {
        float nearest_m = 2.0 * marginOf(u_rayExtent_m) + 8.0 * 1.1920929e-7 * length(light.position.xyz);
        sure = sure && abs(height) > area * double(nearest_m);
    }
    imageStore(i_volumes, volumeTexel(caster, 7), vec4(sure ? 1.0 : 0.0, 0.0, 0.0, 0.0));
}
