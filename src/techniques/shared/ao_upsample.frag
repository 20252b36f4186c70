// SPDX-License-Identifier: MIT
// Occlusion of all pixels from that of one in each 2x2, the lower left (upsampleAo() in techniques/shared/screen_ao.h).
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"

layout(binding = 5) uniform sampler2D t_receivers;

noperspective in vec2 v_uv;
layout(location = 0) out float o_visibility;

void main() {
    ivec2 px = ivec2(gl_FragCoord.xy), first = px >> 1, odd = px & 1;
    float depth = gbufferDepthAt(v_uv);
    if (odd == ivec2(0) || depth == 0.0) {
        o_visibility = depth == 0.0 ? 1.0 : texelFetch(t_receivers, first, 0).r;
        return;
    }
    uvec4 surface = gbufferSurfaceAt(v_uv);
    vec3 p_view = positionViewFromDepth(v_uv, depth), n_s = shadingNormalOf(surface);
    vec3 n_view = mat3(frame.viewFromWorld) * geometricNormalOf(surface);
    float perPixel = 1.0 / pixelSizeAt(-p_view.z);

    // The one, two or four receivers at equal distances. Where none is of this surface the least strange count alike.
    ivec2 last = textureSize(t_receivers, 0) - 1;
    float sum = 0.0, total = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 aside = ivec2(i & 1, i >> 1);
        ivec2 receiver = first + aside;
        if (any(greaterThan(aside, odd)) || any(greaterThan(receiver, last))) continue;
        vec2 uv = (vec2(2 * receiver) + 0.5) * frameViewport.zw;
        float depthThere = gbufferDepthAt(uv);
        if (depthThere == 0.0) continue;
        float plane_px = dot(n_view, positionViewFromDepth(uv, depthThere) - p_view) * perPixel;
        float alike = max(dot(n_s, shadingNormalOf(gbufferSurfaceAt(uv))), 0.0);
        alike *= alike;
        float weight = exp2(-0.72134752 * plane_px * plane_px) * alike * alike + 1e-5 / (1.0 + plane_px * plane_px);
        sum += weight * texelFetch(t_receivers, receiver, 0).r;
        total += weight;
    }
    o_visibility = total > 0.0 ? sum / total : 1.0;
}
