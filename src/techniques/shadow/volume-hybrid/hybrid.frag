// SPDX-License-Identifier: MIT
// What a shadow map knows for certain: every texel about the point says lit, or every texel says dark. The rest is marked for
// the volumes.
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"
#include "ombrage/light.glsl"
#include "shared/light_views.glsl"
#include "shadow/volume-hybrid/params"

#if LIGHT_VIEWS == 1
layout(binding = 5) uniform sampler2D t_map;
#define MAP_TEXEL(texel, view) texelFetch(t_map, texel, 0).r
#else
layout(binding = 5) uniform sampler2DArray t_map;
#define MAP_TEXEL(texel, view) texelFetch(t_map, ivec3(texel, view), 0).r
#endif

layout(location = 0) out float o_visibility;
layout(location = 1) out float o_marked;

noperspective in vec3 v_rayStart;
noperspective in vec3 v_rayAlong;

// Distance along the view's axis from what the map holds; nothing is very far.
float distanceFromMap(int view, float depth) {
    float near_m = VIEW_FORWARD(view).w, far_m = VIEW_ORIGIN(view).w;
    if (depth <= 0.0) return 1e30;
    return LIGHT_PERSPECTIVE != 0 ? near_m / depth : far_m - depth * (far_m - near_m);
}

void main() {
    o_visibility = 1.0;
    o_marked = 0.0;
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 n_world = gbufferGeometricNormal(pixel);
    vec3 p_world = positionOnRay(v_rayStart, v_rayAlong, gbufferDepth(pixel));
    float lightDistance_m;
    vec3 l = directionToLight(p_world, lightDistance_m);
    if (dot(n_world, l) <= 0.0 || irradianceFacing(l, lightDistance_m) == vec3(0.0)) return;

    int view = lightViewOf(p_world);
    int resolution = textureSize(t_map, 0).x;
    float distance_m;
    vec2 uv = lightViewUv(view, p_world, distance_m);
    float texel_m = lightViewTexel(view, distance_m, 1.0 / float(resolution));
    float steepest = params.max_slope * texel_m, precision_m = 4.0 * lightViewPrecision(view, distance_m);

    ivec2 middle = ivec2(floor(uv * float(resolution)));
    int lit = 0, dark = 0, asked = 0;
    for (int dy = -RADIUS; dy <= RADIUS; ++dy)
        for (int dx = -RADIUS; dx <= RADIUS; ++dx) {
            ivec2 texel = middle + ivec2(dx, dy);
            ++asked;
            if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, ivec2(resolution)))) {
                // Beyond a single view nothing casts; beyond the face of a cube lies another one: leave it to the volumes.
                if (LIGHT_VIEWS == 1) ++lit;
                continue;
            }
            // The receiver's tangent plane under the texel's centre.
            vec2 center = (vec2(texel) + 0.5) / float(resolution);
            float plane_m = lightViewPlaneDistance(view, center, p_world, n_world, distance_m);
            plane_m = distance_m + clamp(plane_m - distance_m, -steepest, steepest);
            float before_m = plane_m - distanceFromMap(view, MAP_TEXEL(texel, view));
            if (before_m <= precision_m) ++lit;
            else if (before_m > params.margin * texel_m + precision_m) ++dark;
        }
    if (lit == asked) return;
    if (dark == asked) o_visibility = 0.0;
    else o_marked = 1.0;
}
