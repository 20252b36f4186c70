// SPDX-License-Identifier: MIT
// The words of a G-buffer texel: x octahedral n_g and y n_s (2 x 16 bits signed), z albedo, w global triangle.

// Linear colour in [0,1], square roots of it in 11, 11 and 10 bits: finer than sRGB in 8 bits, and cheaper to undo.
uint packedAlbedo(vec3 linear) {
    uvec3 c = uvec3(sqrt(clamp(linear, 0.0, 1.0)) * vec3(2047.0, 2047.0, 1023.0) + 0.5);
    return c.r | c.g << 11 | c.b << 22;
}

vec3 unpackedAlbedo(uint word) {
    vec3 root = vec3(word & 2047u, (word >> 11) & 2047u, word >> 22) * (1.0 / vec3(2047.0, 2047.0, 1023.0));
    return root * root;
}
