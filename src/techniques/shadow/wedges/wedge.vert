// SPDX-License-Identifier: MIT
// The wedge of one side of a shadow volume: all points from which the side's edge can be seen before the light. Corners 0 and
// 1 are the edge's ends, 2 to 5 lie at infinity (Assarsson and Akenine-Moeller 2003, section 4.1). An instance is a side.
#include "ombrage/clip.glsl"
#include "ombrage/frame.glsl"
#include "ombrage/instances.glsl"
#include "ombrage/light.glsl"
#include "shadow/wedges/params"

layout(std430, binding = 3) readonly buffer Ends { vec4 b_ends[]; };       // VolumeVertices
layout(std430, binding = 4) readonly buffer Indices { uint b_indices[]; };

uniform uint u_instance;   // of the scene
uniform uint u_first;      // index of its first side
uniform uint u_stride;     // indices per side
uniform float u_infinity;  // as in shared/volume_ends.glsl

flat out vec3 v_a;         // the edge, the cap to its left as the light sees it
flat out vec3 v_b;

invariant gl_Position;

// Rounding of positions, as a share of the light's size.
const float kMargin = 1.001;

// Half extent of the light along a unit vector; for a sun of the disk at distance 1.
float extent(vec3 v) {
    float along = dot(v, light.direction.xyz), across = sqrt(max(0.0, 1.0 - along * along));
    float radius = light.cone.z * params.size * kMargin;
    if (LIGHT_IS(LIGHT_POINT)) return radius;
    if (LIGHT_IS(LIGHT_RECT))
        return params.size * kMargin *
               (abs(dot(v, light.tangent.xyz)) * light.tangent.w + abs(dot(v, light.bitangent.xyz)) * light.bitangent.w);
    return radius * across;
}

// A slope that holds v / m for all m in the interval, whatever its sign.
float slope(float v, vec2 m, bool upper) { return v / ((v > 0.0) == upper ? m.x : m.y); }

void main() {
    uint at = u_first + uint(gl_InstanceID) * u_stride;
    mat4 worldFromLocal = b_instances[u_instance].worldFromLocal;
    v_a = (worldFromLocal * b_ends[b_indices[at + 1u]]).xyz;
    v_b = (worldFromLocal * b_ends[b_indices[at]]).xyz;

    // The ends as the light's centre sees them. Along the edge first, then from the light to the edge's line.
    bool isSun = LIGHT_IS(LIGHT_SUN);
    vec3 a = isSun ? light.direction.xyz : v_a - light.position.xyz, b = isSun ? a : v_b - light.position.xyz;
    vec3 y = normalize(v_b - v_a);
    vec3 x = a - y * dot(a, y);
    float distance_m = length(x);
    x = distance_m > 1e-6 * length(a) ? x / distance_m : normalize(cross(y, abs(y.x) < 0.5 ? vec3(1, 0, 0) : vec3(0, 1, 0)));
    vec3 z = cross(x, y);
    vec3 nearA = v_a, nearB = v_b;
    vec2 depth = distance_m + vec2(-1.0, 1.0) * extent(x);
    float low, high, wide;
    if (depth.x > 0.1 * distance_m) {
        // From the light's points to the edge's: depth along x, between low and high along y.
        low = slope(dot(a, y) - extent(y), depth, false);
        high = slope(dot(b, y) + extent(y), depth, true);
        wide = extent(z) / depth.x;
    } else {
        // The edge points at the light or nearly: a pyramid that holds the edge and opens away from the light.
        vec3 middle = 0.5 * (a + b);
        x = normalize(middle);
        vec3 along = v_b - v_a;
        along -= x * dot(along, x);
        y = length(along) > 1e-6 * length(v_b - v_a) ? normalize(along)
                                                     : normalize(cross(x, abs(x.x) < 0.5 ? vec3(1, 0, 0) : vec3(0, 1, 0)));
        z = cross(x, y);
        float nearest = min(dot(a, x), dot(b, x)) - extent(x);
        if (nearest <= 1e-3 * length(middle)) {
            // It touches the light: one triangle over the whole picture, at infinity, and nothing else.
            int corner = gl_VertexID == 3 ? 1 : gl_VertexID == 4 ? 2 : 0;
            gl_Position = vec4(corner == 1 ? 3.0 : -1.0, corner == 2 ? 3.0 : -1.0, 0.0, 1.0);
            return;
        }
        high = (max(abs(dot(a, y)), abs(dot(b, y))) + extent(y)) / nearest;
        low = -high;
        wide = (max(abs(dot(a, z)), abs(dot(b, z))) + extent(z)) / nearest;
        vec3 centre = 0.5 * (v_a + v_b), half_ = 0.5 * (v_b - v_a);
        nearA = nearB = centre - x * (abs(dot(half_, y)) / high + abs(dot(half_, x)));
    }

    vec4 p = vec4(gl_VertexID == 0 ? nearA : nearB, 1.0);
    if (gl_VertexID > 1) {
        float k = (gl_VertexID & 1) == 0 ? low : high, t = gl_VertexID < 4 ? wide : -wide;
        // Where infinity is a point, the rays still start where the wedge does.
        p = vec4(x + y * k + z * t + u_infinity * ((gl_VertexID & 1) == 0 ? nearA : nearB), u_infinity);
    }
    gl_Position = clipFromPosition(frame.clipFromWorld, p);
}
