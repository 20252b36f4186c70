// SPDX-License-Identifier: MIT
// One direction of the separable bilateral filter (Tomasi, Manduchi 1998; Pham, van Vliet 2005). The range weight looks at
// the geometry instead of the image's own values, which are the noise.
#include "filter/bilateral-separable/params"
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"

layout(binding = 5) uniform sampler2D t_input;
uniform ivec2 u_step;   // (1,0) or (0,1)

noperspective in vec2 v_uv;
layout(location = 0) out float o_value;

const float kLog2E = 1.44269504089;

void main() {
    ivec2 px = ivec2(gl_FragCoord.xy);
    float center = texelFetch(t_input, px, 0).r;
    float depth = gbufferDepthAt(v_uv);
    if (depth == 0.0 || params.radius == 0) {
        o_value = center;
        return;
    }
    vec3 p_view = positionViewFromDepth(v_uv, depth);
    uvec4 surface = gbufferSurfaceAt(v_uv);
    vec3 n_view = mat3(frame.viewFromWorld) * geometricNormalOf(surface);
    vec3 n_s = shadingNormalOf(surface);

    // Exponents of 2: Gaussian of the step, Gaussian of the distance from the tangent plane.
    float perStep2 = -0.5 * kLog2E / (params.sigma * params.sigma);
    float tolerance_m = params.plane_tolerance * pixelSizeAt(-p_view.z);
    float perPlane2 = -0.5 * kLog2E / (tolerance_m * tolerance_m);
    ivec2 last = ivec2(frameViewport.xy) - 1;

    float sum = center, total = 1.0;
    for (int i = -params.radius; i <= params.radius; ++i) {
        ivec2 at = px + i * u_step;
        if (i == 0 || any(lessThan(at, ivec2(0))) || any(greaterThan(at, last))) continue;
        vec2 uv = (vec2(at) + 0.5) * frameViewport.zw;
        float depthThere = gbufferDepthAt(uv);
        if (depthThere == 0.0) continue;

        // Distance from the plane, not difference of depths: on a plane seen at a grazing angle it is 0 everywhere.
        float plane_m = dot(n_view, positionViewFromDepth(uv, depthThere) - p_view);
        float exponent = perStep2 * float(i * i) + perPlane2 * plane_m * plane_m;
        if (params.normal_power > 0.0)
            exponent += params.normal_power * log2(max(dot(n_s, shadingNormalOf(gbufferSurfaceAt(uv))), 1e-6));
        float weight = exp2(exponent);
        sum += weight * texelFetch(t_input, at, 0).r;
        total += weight;
    }
    o_value = sum / total;
}
