// SPDX-License-Identifier: MIT
// Bounds of what 64 lanes hold, and the triangle that all of it lies on, if it is one.

#define MANY_TRIANGLES -1.0

shared uint s_lower[3], s_upper[3], s_leastTriangle, s_mostTriangle;

// Unsigned numbers in the order of floats.
uint orderedFromFloat(float x) {
    uint bits = floatBitsToUint(x);
    return (bits >> 31) != 0u ? ~bits : bits | 0x80000000u;
}

float floatFromOrdered(uint ordered) { return uintBitsToFloat((ordered >> 31) != 0u ? ordered & 0x7fffffffu : ~ordered); }

void clearBounds() {
    if (gl_LocalInvocationIndex == 0u) {
        s_leastTriangle = ~0u;
        s_mostTriangle = 0u;
    }
    if (gl_LocalInvocationIndex < 3u) {
        s_lower[gl_LocalInvocationIndex] = orderedFromFloat(3e38);
        s_upper[gl_LocalInvocationIndex] = orderedFromFloat(-3e38);
    }
}

void growBounds(vec3 lower, vec3 upper) {
    for (int axis = 0; axis < 3; ++axis) {
        atomicMin(s_lower[axis], orderedFromFloat(lower[axis]));
        atomicMax(s_upper[axis], orderedFromFloat(upper[axis]));
    }
}

// A place of a triangle as a float, which knows those below 2^24 apart.
float triangleFromPlace(uint place) { return place < 0x1000000u ? float(place) : MANY_TRIANGLES; }

void growTriangles(float triangle) {
    atomicMin(s_leastTriangle, triangle == MANY_TRIANGLES ? 0u : uint(triangle));
    atomicMax(s_mostTriangle, triangle == MANY_TRIANGLES ? ~0u : uint(triangle));
}

float oneTriangle() { return s_leastTriangle == s_mostTriangle ? float(s_leastTriangle) : MANY_TRIANGLES; }

// Of lanes that held nothing the lower bound is above the upper one.
vec3 lowerBound() { return vec3(floatFromOrdered(s_lower[0]), floatFromOrdered(s_lower[1]), floatFromOrdered(s_lower[2])); }
vec3 upperBound() { return vec3(floatFromOrdered(s_upper[0]), floatFromOrdered(s_upper[1]), floatFromOrdered(s_upper[2])); }
