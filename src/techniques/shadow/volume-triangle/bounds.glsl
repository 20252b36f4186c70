// SPDX-License-Identifier: MIT
// Bounds of what 64 lanes hold.

shared uint s_lower[3], s_upper[3];

// Unsigned numbers in the order of floats.
uint orderedFromFloat(float x) {
    uint bits = floatBitsToUint(x);
    return (bits >> 31) != 0u ? ~bits : bits | 0x80000000u;
}

float floatFromOrdered(uint ordered) { return uintBitsToFloat((ordered >> 31) != 0u ? ordered & 0x7fffffffu : ~ordered); }

void clearBounds() {
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

// Of lanes that held nothing the lower bound is above the upper one.
vec3 lowerBound() { return vec3(floatFromOrdered(s_lower[0]), floatFromOrdered(s_lower[1]), floatFromOrdered(s_lower[2])); }
vec3 upperBound() { return vec3(floatFromOrdered(s_upper[0]), floatFromOrdered(s_upper[1]), floatFromOrdered(s_upper[2])); }
