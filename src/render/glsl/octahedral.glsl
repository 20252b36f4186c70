// SPDX-License-Identifier: MIT
// Octahedral unit vectors (Meyer et al. 2010; Cigolle et al. 2014, "A survey of efficient representations").

vec2 octahedralFold(vec2 o) { return (1.0 - abs(o.yx)) * vec2(o.x >= 0.0 ? 1.0 : -1.0, o.y >= 0.0 ? 1.0 : -1.0); }

// Of a vector of any length; 0 gives the z axis.
vec2 octahedralFromVector(vec3 n) {
    vec2 o = n.xy * (1.0 / max(abs(n.x) + abs(n.y) + abs(n.z), 1e-36));
    return n.z >= 0.0 ? o : octahedralFold(o);
}

// unpackSnorm2x16() without its division and clamping, which packSnorm2x16() makes needless.
vec2 octahedralFromWord(uint word) { return vec2(int(word << 16) >> 16, int(word) >> 16) * (1.0 / 32767.0); }

// The vector of unit 1-norm.
vec3 vectorFromOctahedral(vec2 o) {
    vec3 n = vec3(o, 1.0 - abs(o.x) - abs(o.y));
    float t = max(-n.z, 0.0);
    n.xy += vec2(n.x >= 0.0 ? -t : t, n.y >= 0.0 ? -t : t);
    return n;
}

vec3 unitFromOctahedral(vec2 o) { return normalize(vectorFromOctahedral(o)); }

// Of the opposite vector: folding trades the halves, and the sign turns what is left.
vec2 octahedralOpposite(vec2 o) { return -octahedralFold(o); }
