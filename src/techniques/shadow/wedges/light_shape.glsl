// SPDX-License-Identifier: MIT
// The light's outline as a receiver sees it: a disk or a rectangle about the light's centre, on which coordinates run from -1
// to 1. Spheres and suns are the disk that their cone of directions cuts out.
#include "shared/light_sampling.glsl"
#include "shadow/wedges/params"

struct LightOutline {
    vec3 toCentre;     // from the receiver; a unit vector for a sun
    vec3 towards;      // unit normal of the outline's plane, away from the receiver
    vec3 axisX, axisY; // unit
    vec2 halfSize;     // metres, at the distance of the plane
    float distance_m;  // from the receiver to the plane
    float turn;        // 1: the axes run counter-clockwise as seen from the light, -1: clockwise
    bool seen;         // from its bright side, and from outside
};

// Tangent of the half angle of a sphere's or sun's cone, which shines evenly in solid angle; 0: an outline even in area.
float g_coneTangent = 0.0;

const float kSmallest = 1e-6;   // of a side of a rect that has none, in metres; of distances, of that to the light

LightOutline outlineOf(vec3 p_world) {
    LightOutline o;
    o.seen = true;
    o.turn = 1.0;
    if (LIGHT_IS(LIGHT_SUN)) {
        o.toCentre = o.towards = -light.direction.xyz;
        o.distance_m = 1.0;
        o.halfSize = vec2(light.cone.z * params.size);
        g_coneTangent = o.halfSize.x;
    } else {
        o.toCentre = light.position.xyz - p_world;
        if (LIGHT_IS(LIGHT_POINT)) {
            o.distance_m = length(o.toCentre);
            o.towards = o.toCentre / o.distance_m;
            float radius = light.cone.z * params.size, rest2 = o.distance_m * o.distance_m - radius * radius;
            o.seen = rest2 > 0.0;
            o.halfSize = vec2(radius * o.distance_m * inversesqrt(max(rest2, 1e-12)));
            g_coneTangent = o.halfSize.x / o.distance_m;
        } else {
            o.towards = -light.direction.xyz;
            o.distance_m = dot(o.toCentre, o.towards);
            o.seen = o.distance_m > 0.0;
            o.axisX = light.tangent.xyz;
            o.axisY = light.bitangent.xyz;
            o.turn = -1.0;
            o.halfSize = LIGHT_IS(LIGHT_RECT) ? max(vec2(light.tangent.w, light.bitangent.w) * params.size, kSmallest)
                                              : vec2(light.cone.z * params.size);
            return o;
        }
    }
    basisOf(o.towards, o.axisX, o.axisY);
    return o;
}

// Where the ray from the receiver to `offset` (from the receiver) meets the outline's plane: coordinates times z, and z, the
// distance along the plane's normal.
vec3 projected(LightOutline o, vec3 offset) {
    float z = dot(offset, o.towards);
    vec3 aside = offset - o.toCentre * (z / o.distance_m);
    return vec3(vec2(dot(aside, o.axisX), dot(aside, o.axisY)) * o.distance_m / o.halfSize, z);
}

// The receiver's tangent plane on the outline: points q with dot(xy, q) + z < 0 are below the horizon. Scaled so that xy is
// a unit vector; a plane that misses the outline's circumcircle is far away.
vec3 horizonOf(LightOutline o, vec3 n) {
    vec3 line = vec3(dot(n, o.axisX) * o.halfSize.x, dot(n, o.axisY) * o.halfSize.y, dot(n, o.toCentre));
    float slope = length(line.xy);
    return slope > 1e-20 ? line / slope : vec3(1.0, 0.0, line.z < 0.0 ? -1e6 : 1e6);
}
