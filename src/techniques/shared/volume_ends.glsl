// SPDX-License-Identifier: MIT
// Where the corners of shadow volumes are. FINITE: volumes end after u_distance. SLABS: they lie between two planes each. ONTO_NEAR_PLANE: caps as the light
// casts them onto the near plane.
#include "ombrage/clip.glsl"
#include "ombrage/frame.glsl"

uniform vec4 u_toward;      // towards the light: (position, 1), or (direction to the sun, 0)
uniform float u_infinity;   // w of points at infinity: 0; above 0 for orthographic cameras, which cannot show them
uniform float u_distance;   // metres

#ifdef SLABS
struct Slab { vec4 near, far; };   // planes; zero: none
layout(std430, binding = 10) readonly buffer Slabs { Slab b_slabs[]; };   // one per instance

// Where the light's ray through p meets a plane (Blinn 1988); homogeneous.
vec4 ontoPlane(vec4 plane, vec3 p_world) {
    vec4 p = vec4(p_world, 1.0);
    return dot(plane, p) * u_toward - dot(plane, u_toward) * p;
}
#endif

vec4 nearEnd(vec3 p_world, uint caster) {
#ifdef SLABS
    if (b_slabs[caster].near != vec4(0.0)) return ontoPlane(b_slabs[caster].near, p_world);
#endif
    return vec4(p_world, 1.0);
}

vec4 farEnd(vec3 p_world, uint caster) {
#ifdef SLABS
    if (b_slabs[caster].far != vec4(0.0)) return ontoPlane(b_slabs[caster].far, p_world);
#endif
    // Everitt and Kilgard 2002, section 5.1: V * L.w - L, at infinity along the ray from the light.
    vec3 away = p_world * u_toward.w - u_toward.xyz;
#ifdef FINITE
    return vec4(p_world + normalize(away) * u_distance, 1.0);
#else
    // Where infinity is a point, a lamp's far ends lie on their rays all the same; those of a sun are one point.
    float w = u_toward.w != 0.0 ? u_infinity * length(away) : u_infinity;
    return vec4(away + p_world * (w * u_toward.w), w);
#endif
}

#ifdef ONTO_NEAR_PLANE
out float gl_ClipDistance[2];

// The plane's equation is w - z in clip space, so with s its value, the light's ray through X meets it at
// s(L) X - s(X) L (Hornus 2005; Blinn 1988). Only what lies between the plane and the light counts.
vec4 ontoNearPlane(vec4 clip) {
    vec4 light = clipFromPosition(frame.clipFromWorld, u_toward);
    float s_light = light.w - light.z, s = clip.w - clip.z;
    float side = s_light < 0.0 ? -1.0 : 1.0;
    gl_ClipDistance[0] = s * side;
    gl_ClipDistance[1] = u_toward.w != 0.0 ? (s_light - s) * side : 1.0;
    vec4 p = (s_light * clip - s * light) * side;
    p.z = 0.5 * p.w;   // depth says nothing here
    return p;
}
#endif
