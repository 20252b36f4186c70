// SPDX-License-Identifier: MIT
// Where lines from a point of the plane to a light of some size pass a height over the plane, in the mask of flattened casters.
#include "ombrage/frame.glsl"
#include "shared/light_sampling.glsl"

uniform vec4 u_plane, u_toward;
uniform vec2 u_zoom;     // the picture's share of the mask
uniform float u_radius;  // of the constant disk, in metres or (PIXELS) in pixels

// A disk as the mask shows it: its centre and two half axes, clip x, y, w.
struct DiskImage {
    vec3 centre, u, v;
};

vec3 clipXyw(vec4 p_world) {
    vec4 clip = frame.clipFromWorld * p_world;
    return vec3(clip.xy * u_zoom, clip.w);
}

// A point of the unit disk in the mask; outside of [0,1] where that does not show it.
vec2 maskPlace(DiskImage image, vec2 point) {
    vec3 clip = image.centre + image.u * point.x + image.v * point.y;
    return clip.z > 0.0 ? clip.xy / clip.z * 0.5 + 0.5 : vec2(-1.0);
}

// The light as a disk that faces the point: half axes, as differences of homogeneous places towards it. Of spheres and suns it
// is the disk that their cone cuts out, `tangent` that of the cone's half angle: they shine evenly in solid angle.
struct LightDisk {
    vec3 u, v;
    float tangent;   // 0: evenly in area
};

LightDisk lightDisk(vec3 p_world) {
    LightDisk disk;
    float radius = light.cone.z;
    disk.tangent = 0.0;
    if (LIGHT_IS(LIGHT_SPOT)) {
        disk.u = light.tangent.xyz;
        disk.v = light.bitangent.xyz;
    } else if (LIGHT_IS(LIGHT_SUN)) {
        basisOf(u_toward.xyz, disk.u, disk.v);
        disk.tangent = radius;
    } else {
        // The cone about a sphere meets the plane through its centre in a wider disk; within the sphere all is one point.
        vec3 d = light.position.xyz - p_world;
        float distance2 = dot(d, d), rest = distance2 - radius * radius;
        disk.tangent = rest > 0.0 ? radius * inversesqrt(rest) : 0.0;
        radius = disk.tangent * sqrt(distance2);
        basisOf(normalize(d), disk.u, disk.v);
    }
    disk.u *= radius;
    disk.v *= radius;
    return disk;
}

// 1 - cos of the half angle of the cone.
float oneMinusCos(float tangent) {
    float t2 = tangent * tangent, secant = sqrt(1.0 + t2);
    return t2 / (secant * (secant + 1.0));
}

// A point of the unit disk, even in area, moved to where the light shines as evenly.
vec2 evenly(LightDisk disk, vec2 point) {
    if (disk.tangent < 1e-3) return point;
    float height = dot(point, point) * oneMinusCos(disk.tangent);   // 1 - cos of its angle to the axis
    return point * (sqrt(height * (2.0 - height)) / ((1.0 - height) * max(length(point), 1e-6) * disk.tangent));
}

// How wide the light's image is past a blocker at a height: k(h) = h / (H - h w); constant disks do not grow.
float growthAt(float height_m, float lightHeight) {
#ifdef CONTACT
    return height_m / (lightHeight - height_m * u_toward.w);
#else
    return 1.0;
#endif
}

// Where the line from p to the place L' of the light is at the height h: q = p + (L' - w p) h / H' with H' = P.L', flattened like a
// caster: H q - h L. Multiplied by H' it is linear in L', so the whole disk takes three of them.
vec3 flattenedBlocker(vec3 p_world, vec4 place, float lightHeight, float height_m) {
    float placeHeight = dot(u_plane, place);
    vec3 q_world = p_world * placeHeight + (place.xyz - place.w * p_world) * height_m;
    return clipXyw(lightHeight * vec4(q_world, placeHeight) - height_m * placeHeight * u_toward);
}

DiskImage blockerImage(LightDisk disk, vec3 p_world, float lightHeight, float height_m) {
    return DiskImage(flattenedBlocker(p_world, u_toward, lightHeight, height_m),
                     flattenedBlocker(p_world, vec4(disk.u, 0.0), lightHeight, height_m),
                     flattenedBlocker(p_world, vec4(disk.v, 0.0), lightHeight, height_m));
}

// The disk of constant width about a point of the plane.
DiskImage constantImage(vec3 p_world) {
    vec3 centre = clipXyw(vec4(p_world, 1.0));
#ifdef PIXELS
    vec2 radius = 2.0 * u_radius * frame.viewport.zw * u_zoom * centre.z;
    return DiskImage(centre, vec3(radius.x, 0.0, 0.0), vec3(0.0, radius.y, 0.0));
#else
    vec3 u, v;
    basisOf(u_plane.xyz, u, v);
    return DiskImage(centre, clipXyw(vec4(u * u_radius, 0.0)), clipXyw(vec4(v * u_radius, 0.0)));
#endif
}
