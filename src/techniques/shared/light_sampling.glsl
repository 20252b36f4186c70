// SPDX-License-Identifier: MIT
// Points of the bound light: spheres and suns uniform in the solid angle of their cone, rects and the disk of a spot uniform in
// area; rects and disks of a size shine on one side.
#include "ombrage/light.glsl"
#include "shared/basis.glsl"

struct LightSample {
    vec3 direction;    // unit, towards the light
    float distance_m;  // to its surface; huge for a sun
    bool facing;       // its lit side is seen
};

// Direction in the cone about `axis`; 1 - cos of its half angle is kept apart because it loses all digits in small cones.
vec3 coneDirection(vec3 axis, float oneMinusCos, vec2 u) {
    vec3 t, b;
    basisOf(axis, t, b);
    float height = u.x * oneMinusCos;
    float sine = sqrt(max(0.0, height * (2.0 - height)));
    float phi = 6.28318530717959 * u.y;
    return normalize(axis * (1.0 - height) + (t * cos(phi) + b * sin(phi)) * sine);
}

LightSample lightCentre(vec3 p_world) {
    LightSample s;
    s.direction = directionToLight(p_world, s.distance_m);
    s.facing = int(light.color.w) != LIGHT_RECT || dot(s.direction, light.direction.xyz) < 0.0;
    return s;
}

// Whether a hard light may shine on a surface: in range, inside of the cone, above the horizon.
bool reachesCentre(vec3 n_g, LightSample centre) {
    if (centre.distance_m > light.direction.w || dot(centre.direction, n_g) <= 0.0 || !centre.facing) return false;
    return int(light.color.w) != LIGHT_SPOT || dot(-centre.direction, light.direction.xyz) >= light.cone.y;
}

LightSample sampleLight(vec3 p_world, vec2 u) {
    LightSample s;
    s.facing = true;
    int type = int(light.color.w);
    if (type == LIGHT_SUN) {
        // 1 - cos from the tangent of half the angle.
        float t2 = light.cone.z * light.cone.z, secant = sqrt(1.0 + t2);
        s.direction = coneDirection(-light.direction.xyz, t2 / (secant * (secant + 1.0)), u);
        s.distance_m = 1e30;
        return s;
    }
    vec3 toCentre = light.position.xyz - p_world;
    if (type == LIGHT_POINT) {
        // Seen from outside a cone of sine radius / distance; from within all directions.
        float distance2 = dot(toCentre, toCentre), radius2 = light.cone.z * light.cone.z;
        bool inside = distance2 <= radius2;
        float sine2 = inside ? 0.0 : radius2 / distance2;
        vec3 axis = distance2 > 0.0 ? toCentre * inversesqrt(distance2) : vec3(0.0, 1.0, 0.0);
        s.direction = coneDirection(axis, inside ? 2.0 : sine2 / (1.0 + sqrt(1.0 - sine2)), u);
        // The near side of the sphere, or its far side from within.
        float along = dot(toCentre, s.direction);
        float halfChord = sqrt(max(0.0, radius2 - distance2 + along * along));
        s.distance_m = max(0.0, inside ? along + halfChord : along - halfChord);
        return s;
    }
    vec2 offset;
    if (type == LIGHT_RECT) {
        offset = (2.0 * u - 1.0) * vec2(light.tangent.w, light.bitangent.w);
    } else {
        float r = light.cone.z * sqrt(u.x), phi = 6.28318530717959 * u.y;
        offset = r * vec2(cos(phi), sin(phi));
    }
    vec3 d = toCentre + light.tangent.xyz * offset.x + light.bitangent.xyz * offset.y;
    s.distance_m = length(d);
    s.direction = d / s.distance_m;
    s.facing = dot(s.direction, light.direction.xyz) < 0.0;
    return s;
}
