// SPDX-License-Identifier: MIT
// V = 1 - (s / N) sum max(0, n.d - cos(angle)) max(0, 1 - D^2 / r^2), d the unit vector and D the distance from the
// receiver to the surface found at a sample.
#include "ao/blocks/params"
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"
#include "shared/sample_patterns.glsl"

uniform vec4 u_kernel[SAMPLES];   // offsets in the unit disk or half ball; w their weight
uniform float u_radius_m;

layout(location = 0) out float o_visibility;

const float kTwoPi = 6.28318530718;

// A share of a full turn for this pixel.
float turnOfPixel(ivec2 px) {
    uint seed = frame.random.x;
    if (params.rotation == ROTATION_NONE) return 0.0;
    if (params.rotation == ROTATION_GRADIENT) {
        // Interleaved gradient noise (Jimenez 2014); each seed looks at another part of the pattern.
        vec2 p = vec2(px) + 5.588238 * float(seed & 63u);
        return fract(52.9829189 * fract(dot(p, vec2(0.06711056, 0.00583715))));
    }
    if (params.rotation == ROTATION_HASH) return unitFromBits(hashOf(hashOf(uint(px.y), seed), uint(px.x)));
    // The 16 turns of a 4x4 tile, neighbours far apart (ordered dither), moved by the seed.
    uvec2 t = (uvec2(px) + uvec2(seed, seed >> 2u)) & 3u;
    uint x = t.x ^ t.y;
    uint order = ((x & 1u) << 3u) | ((t.y & 1u) << 2u) | (x & 2u) | (t.y >> 1u);
    return float(order) / 16.0;
}

void main() {
    ivec2 px = ivec2(gl_FragCoord.xy);
    // By the same operations as of a sample below, so that the receiver itself is at distance 0.
    vec2 uv = (vec2(px) + 0.5) * frameViewport.zw;
    float depth = gbufferDepthAt(uv);
    if (depth == 0.0) {
        o_visibility = 1.0;
        return;
    }
    vec3 n_view = mat3(frame.viewFromWorld) * shadingNormalOf(gbufferSurfaceAt(uv));
    vec3 p_view = positionViewFromDepth(uv, depth);

    // The kernel turned about its axis, in pixels of the picture or in metres over the surface.
    float turn = kTwoPi * turnOfPixel(px);
    vec2 axis = vec2(cos(turn), sin(turn));
#if OFFSETS == OFFSETS_SCREEN
    float radius_px = u_radius_m / pixelSizeAt(-p_view.z);
    vec2 axisX = axis * radius_px, axisY = vec2(-axis.y, axis.x) * radius_px;
#else
    // A frame about n without branches (Duff et al. 2017).
    float side = n_view.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (side + n_view.z), b = n_view.x * n_view.y * a;
    vec3 t_view = vec3(1.0 + side * n_view.x * n_view.x * a, side * b, -side * n_view.x);
    vec3 b_view = vec3(b, side + n_view.y * n_view.y * a, -n_view.y);
    vec3 axisX = (t_view * axis.x + b_view * axis.y) * u_radius_m;
    vec3 axisY = (b_view * axis.x - t_view * axis.y) * u_radius_m;
    vec3 axisZ = n_view * u_radius_m;
#endif
    vec3 origin_view = p_view + n_view * params.bias;

    float cosAngle = cos(params.angle), perRadius2 = 1.0 / (u_radius_m * u_radius_m);
    float sum = 0.0, total = 0.0;
    for (int i = 0; i < SAMPLES; ++i) {
        vec4 k = u_kernel[i];
#if OFFSETS == OFFSETS_SCREEN
        vec2 at_px = gl_FragCoord.xy + axisX * k.x + axisY * k.y;
#else
        vec3 q_view = p_view + axisX * k.x + axisY * k.y + axisZ * k.z;
        vec2 plane = q_view.xy / (isOrthographic() ? frameProjection.zw : -q_view.z * frameProjection.zw);
        vec2 at_px = (plane * 0.5 + 0.5) * frameViewport.xy;
        if (!isOrthographic() && q_view.z >= 0.0) continue;
#endif
        // Nothing is known outside the picture: such a sample counts neither as open nor in N (algorithm 3 of the
        // method clamps it to the border instead, which repeats the border's surface as occluder).
        if (any(lessThan(at_px, vec2(0.0))) || any(greaterThanEqual(at_px, frameViewport.xy))) continue;
        total += k.w;

        vec2 uvFound = (floor(at_px) + 0.5) * frameViewport.zw;
        float depthFound = gbufferDepthAt(uvFound);
        vec3 d = positionViewFromDepth(uvFound, depthFound) - origin_view;
        float distance2 = dot(d, d);
        float near = 1.0 - distance2 * perRadius2;
        // The sky and the receiver itself are open.
        if (depthFound == 0.0 || near <= 0.0 || distance2 == 0.0) continue;
        sum += k.w * near * max(0.0, dot(n_view, d) * inversesqrt(distance2) - cosAngle);
    }
    o_visibility = total > 0.0 ? clamp(1.0 - params.intensity * sum / total, 0.0, 1.0) : 1.0;
}
