// SPDX-License-Identifier: MIT
// The largest share of depths at z0 or beyond that four moments allow (Peters, Klein 2015, section 4).

// Standard deviation and mean, and what tells a distribution of that shape from others: skewness, and how much larger its kurtosis is
// than that of two depths.
struct MomentShape {
    float mean, deviation;
    float skewness, excess;
};

MomentShape momentShape(vec4 moments) {
    // The Hankel matrix ((1, b1, b2), (b1, b2, b3), (b2, b3, b4)) = L D L^T; all of D is positive for more than two depths.
    float variance = max(moments.y - moments.x * moments.x, 1e-10);
    float covariance = moments.z - moments.x * moments.y;
    float d33 = moments.w - moments.y * moments.y - covariance * covariance / variance;
    MomentShape shape;
    shape.mean = moments.x;
    shape.deviation = sqrt(variance);
    shape.skewness = (covariance / variance - 2.0 * moments.x) / shape.deviation;
    shape.excess = max(d33 / (variance * variance), 1e-6);
    return shape;
}

// The largest share that can lie at x exactly, in deviations from the mean: 1 / (k^T B^-1 k) with k = (1, x, x^2) in the basis that
// makes B diagonal, a sum of squares.
float shareAt(MomentShape shape, float x) {
    float quadratic = x * x - shape.skewness * x - 1.0;
    return 1.0 / (1.0 + x * x + quadratic * quadratic / shape.excess);
}

// The two depths beside x0 where the distribution lies that has these moments and the most in front of x0: the roots of k0^T B^-1 k. One
// is infinite at two places of x0, and has no share there.
vec2 depthsBeside(MomentShape shape, float x0) {
    float quadratic = x0 * x0 - shape.skewness * x0 - 1.0;
    float a = quadratic, b = shape.excess * x0 - quadratic * shape.skewness, c = shape.excess - quadratic;
    float h = -0.5 * (b + (b < 0.0 ? -1.0 : 1.0) * sqrt(max(b * b - 4.0 * a * c, 0.0)));
    vec2 roots = vec2(h / (abs(a) > 1e-18 ? a : 1e-18), c / (abs(h) > 1e-18 ? h : 1e-18));
    roots = clamp(roots, -1e6, 1e6);
    return vec2(min(roots.x, roots.y), max(roots.x, roots.y));
}

// Depths may be any number (section 4.1).
float hamburgerBound(vec4 moments, float z0) {
    MomentShape shape = momentShape(moments);
    float x0 = (z0 - shape.mean) / shape.deviation;
    vec2 beside = depthsBeside(shape, x0);
    if (x0 > beside.y) return shareAt(shape, x0);
    return x0 > beside.x ? 1.0 - shareAt(shape, beside.x) : 1.0;
}

// Depths lie in [-1,1]. Where one of Hamburger's does not, both ends of the range, z0 and one depth between take their place.
float hausdorffBound(vec4 moments, float z0) {
    MomentShape shape = momentShape(moments);
    float x0 = (z0 - shape.mean) / shape.deviation;
    vec2 beside = depthsBeside(shape, x0);
    vec2 ends = (vec2(-1.0, 1.0) - shape.mean) / shape.deviation;
    if (beside.x >= ends.x && beside.y <= ends.y) {
        if (x0 > beside.y) return shareAt(shape, x0);
        return x0 > beside.x ? 1.0 - shareAt(shape, beside.x) : 1.0;
    }
    // Expectations of (1 - z^2)(z - z0) and of the same times z: the free depth is their quotient.
    float weighted = moments.x - moments.z - z0 * (1.0 - moments.y);
    float weightedDepth = moments.y - moments.w - z0 * (moments.x - moments.z);
    float free = clamp(weightedDepth / (abs(weighted) > 1e-18 ? weighted : 1e-18), -1.0 + 1e-6, 1.0 - 1e-6);
    // Shares by Lagrange's polynomials, which are 1 at one of the four depths and 0 at the others.
    float shareFree = weighted / ((1.0 - free * free) * (free - z0));
    float shareNear = (moments.z - (1.0 + z0 + free) * moments.y + (z0 + free + z0 * free) * moments.x - z0 * free) /
                      (-2.0 * (1.0 + z0) * (1.0 + free));
    return clamp(1.0 - shareNear - (free < z0 ? shareFree : 0.0), 0.0, 1.0);
}
