// SPDX-License-Identifier: MIT
// Pixels at an edge of the hard shadow, and how far it will be blurred.
#include "shadow/volume-blur/penumbra.glsl"

layout(location = 0) out uvec2 o_edge;

layout(binding = 5) uniform sampler2D t_hard;
#if MODE == MODE_CONTACT
layout(binding = 6) uniform sampler2D t_contact;
layout(binding = 7) uniform sampler2D t_nearness;   // contact.frag; 0: no side

// Distance of a surface from a side that ends the shadow there, in pixels' sizes as the surface shows them. More means that
// the right side was not drawn there.
const float kNear = 1.5;

// By so much less a neighbour's must be.
const float kOwn = 0.5;
#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy), last = ivec2(frame.viewport.xy) - 1;
    o_edge = uvec2(kNoEdge, 0u);
    float hard = texelFetch(t_hard, pixel, 0).r, depth = gbufferDepth(pixel);
    vec3 p_world = positionOf(pixel, depth), n_g = gbufferGeometricNormal(pixel);
    float pixel_m = pixelSizeAt(viewDepthFromDepth(depth));

    bool isEdge = false;
#if MODE == MODE_CONTACT
    // The distance that the nearest of the sides over the pixel has; that of a neighbour beyond the edge where one is clearly
    // nearer there, as at a volume's corners. A neighbour may have another shadow's, across a narrow gap.
    float stretch = 1.0 / max(dot(n_g, directionToEye(p_world)), 0.05);
    float aside = 1.0 / max(texelFetch(t_nearness, pixel, 0).r, 1e-6) - 1.0 - kOwn * stretch;
    float contact = texelFetch(t_contact, pixel, 0).r;
#endif
    const ivec2 steps[4] = ivec2[](ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1), ivec2(0, -1));
    for (int i = 0; i < 4; ++i) {
        ivec2 at = clamp(pixel + steps[i], ivec2(0), last);
        if (!isSameSurface(p_world, n_g, pixel_m, at, 0.0)) continue;
        if (texelFetch(t_hard, at, 0).r == hard) continue;
        isEdge = true;
#if MODE == MODE_CONTACT
        float asideThere = 1.0 / max(texelFetch(t_nearness, at, 0).r, 1e-6) - 1.0;
        if (asideThere < aside) {
            aside = asideThere;
            contact = texelFetch(t_contact, at, 0).r;
        }
#endif
    }
    if (!isEdge) return;

#if MODE == MODE_CONTACT
    if (aside > kNear * stretch) return;
    float radius_m = penumbraRadius_m(p_world, n_g, contact);
#else
    float contact = 0.0, radius_m = constantRadius_m(pixel_m);
#endif
    float radius_px = min(radius_m / pixel_m, params.reach);
    o_edge = uvec2(uint(pixel.x) | uint(pixel.y) << 16, packHalf2x16(vec2(radius_px, contact)));
}
