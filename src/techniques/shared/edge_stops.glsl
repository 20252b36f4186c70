// SPDX-License-Identifier: MIT
// How alike the surfaces of two pixels are, for filters that must not mix them. It looks at the geometry alone: the differences of
// the image's own values are the very noise to be removed. Needs ombrage/frame.glsl and ombrage/gbuffer.glsl.
struct EdgeStops {
    vec3 p_view, n_view;   // of the surface, n_view geometric
    vec3 n_s;              // shading normal, in world space
    float perPlane2;       // of a squared distance, in an exponent of 2
    float normalPower;
};

const float kLog2E = 1.44269504089;

// Of the pixel around `uv`, whose depth is not the sky's. tolerance_px: distance from the tangent plane, in sizes of a pixel there,
// at which a neighbour's weight has fallen by exp(-1/2).
EdgeStops edgeStopsAt(vec2 uv, float depth, float tolerance_px, float normalPower) {
    EdgeStops stops;
    stops.p_view = positionViewFromDepth(uv, depth);
    uvec4 surface = gbufferSurfaceAt(uv);
    stops.n_view = mat3(frame.viewFromWorld) * geometricNormalOf(surface);
    stops.n_s = shadingNormalOf(surface);
    float tolerance_m = tolerance_px * pixelSizeAt(-stops.p_view.z);
    stops.perPlane2 = -0.5 * kLog2E / (tolerance_m * tolerance_m);
    stops.normalPower = normalPower;
    return stops;
}

// Exponent of 2 of the weight of the pixel around `uv`, whose depth is not the sky's.
float edgeStopExponent(EdgeStops stops, vec2 uv, float depth) {
    // Distance from the plane, not difference of depths: on a plane seen at a grazing angle it is 0 everywhere.
    float plane_m = dot(stops.n_view, positionViewFromDepth(uv, depth) - stops.p_view);
    float exponent = stops.perPlane2 * plane_m * plane_m;
    if (stops.normalPower > 0.0)
        exponent += stops.normalPower * log2(max(dot(stops.n_s, shadingNormalOf(gbufferSurfaceAt(uv))), 1e-6));
    return exponent;
}
