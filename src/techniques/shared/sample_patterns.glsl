// SPDX-License-Identifier: MIT
// Points of the unit square for the samples of one pixel.

// Hash of two words with good avalanche: two rounds of the 32-bit finaliser of MurmurHash3.
uint hashOf(uint a, uint b) {
    uint x = a * 0x9e3779b9u ^ b;
    for (int i = 0; i < 2; ++i) {
        x ^= x >> 16;
        x *= 0x85ebca6bu;
        x ^= x >> 13;
        x *= 0xc2b2ae35u;
        x ^= x >> 16;
        x += b;
    }
    return x;
}

// 24 bits to [0,1), so that rounding never reaches 1.
float unitFromBits(uint bits) { return float(bits >> 8) * (1.0 / 16777216.0); }

// Sobol's second dimension: Pascal's triangle modulo 2, a column per bit of the index.
uint sobolSecond(uint index) {
    uint result = 0u;
    for (uint column = 0x80000000u; index != 0u; index >>= 1, column ^= column >> 1)
        if ((index & 1u) != 0u) result ^= column;
    return result;
}

// Owen's nested uniform scrambling by hash (Laine and Karras 2011, constants of Burley 2020) between two reversals of bits.
uint owenScramble(uint bits, uint seed) {
    uint x = bitfieldReverse(bits) + seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    x ^= x * 0x8d22f6e6u;
    return bitfieldReverse(x);
}

// Independent points.
vec2 randomPoint(uint index, uint seed) {
    uint h = hashOf(seed, index);
    return vec2(unitFromBits(h), unitFromBits(hashOf(h, 0x68bc21ebu)));
}

// Point of the Sobol sequence, scrambled and shuffled by the seed (Burley 2020, section 5).
vec2 owenSobolPoint(uint index, uint seed) {
    uint shuffled = owenScramble(index, seed);
    return vec2(unitFromBits(owenScramble(bitfieldReverse(shuffled), hashOf(seed, 1u))),
                unitFromBits(owenScramble(sobolSecond(shuffled), hashOf(seed, 2u))));
}

// Interleaved gradient noise (Jimenez 2014), [0,1).
float gradientNoise(vec2 px) { return fract(52.9829189 * fract(dot(px, vec2(0.06711056, 0.00583715)))); }

// One Sobol set for all pixels, moved by interleaved gradient noise (Jimenez 2014), so that neighbours share few errors.
vec2 rotatedSobolPoint(uint index, uint seed, vec2 px) {
    return fract(owenSobolPoint(index, seed) + vec2(gradientNoise(px), gradientNoise(px.yx + 5.588238)));
}
