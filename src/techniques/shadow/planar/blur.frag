// SPDX-License-Identifier: MIT
// The shadow of a light with a size, from the flattened casters' mask and heights. CONTACT: points of the light looked at past a
// caster of the height found around (Fernando 2005, on the plane instead of in a map); else the mask's mean over a disk of one
// width, in metres on the plane or (PIXELS) in the picture. COLORED: the light that passes, in colour, too.
#include "ombrage/gbuffer.glsl"
#include "shadow/planar/penumbra.glsl"
#include "shadow/planar/style.glsl"

layout(binding = 5) uniform sampler2D t_mask;    // x: covered, filtered; y: less the height in metres, a texel's own
layout(binding = 6) uniform sampler2D t_reach;   // reach.frag
layout(binding = 7) uniform sampler2D t_casterColor;

uniform vec4 u_kernel[SAMPLES];   // xy: even in the unit disk; zw: denser towards the middle
uniform vec2 u_tileInMask;        // a tile's share of the mask

in vec3 v_rayStart;
in vec3 v_rayAlong;

layout(location = 0) out float o_visibility;
#ifdef COLORED
layout(location = 1) out vec4 o_colored;
#endif

bool isInMask(vec2 uv) { return all(greaterThanEqual(uv, vec2(0.0))) && all(lessThanEqual(uv, vec2(1.0))); }

struct Sum {
    float covered, count;
    vec3 color;
};

void addTo(inout Sum sum, vec2 uv) {
    if (!isInMask(uv)) return;
    float covered = texture(t_mask, uv).x;
    sum.covered += covered;
    sum.count += 1.0;
#if defined(COLORED) && STYLE == STYLE_TEXTURED
    sum.color += covered * texture(t_casterColor, uv).rgb;
#endif
}

#ifdef CONTACT
// The mean height of the blockers whose own half-shadow reaches the point, at most `highest_m`; less than 0 without any. A place
// of the mask at the share s of the disk belongs to those of the height h where s k(highest) <= k(h).
float blockerHeight(LightDisk disk, vec3 p_world, float lightHeight, float highest_m) {
    float widest = growthAt(highest_m, lightHeight), sum_m = 0.0, blockers = 0.0;
    DiskImage image = blockerImage(disk, p_world, lightHeight, highest_m);
    for (int i = 0; i < SAMPLES; ++i) {
        vec2 uv = maskPlace(image, u_kernel[i].zw);
        if (!isInMask(uv)) continue;
        ivec2 size = textureSize(t_mask, 0);
        vec2 found = texelFetch(t_mask, min(ivec2(uv * vec2(size)), size - 1), 0).xy;
        float height_m = min(-found.y, highest_m);
        bool reaches = length(u_kernel[i].zw) * widest <= growthAt(height_m, lightHeight);
        if (found.x > 0.0 && reaches) {
            sum_m += height_m;
            blockers += 1.0;
        }
    }
    return blockers > 0.0 ? sum_m / blockers : -1.0;
}
#endif

Sum covering(vec3 p_world, float highest_m) {
    Sum sum = Sum(0.0, 0.0, vec3(0.0));
#ifdef CONTACT
    float lightHeight = dot(u_plane, u_toward);
    LightDisk disk = lightDisk(p_world);
    // What has sunk under the plane is blocked by it.
    vec2 rise = vec2(dot(u_plane.xyz, disk.u), dot(u_plane.xyz, disk.v));
    float low = 1e-4 * lightHeight;
    bool sinks = lightHeight - length(rise) < low;
    float height_m = highest_m < 0.0 ? -1.0 : blockerHeight(disk, p_world, lightHeight, highest_m);
    if (height_m < 0.0 && !sinks) return sum;
    DiskImage image = blockerImage(disk, p_world, lightHeight, max(height_m, 0.0));
#else
    if (highest_m < 0.0) return sum;
    DiskImage image = constantImage(p_world);
#endif
    for (int i = 0; i < SAMPLES; ++i) {
#ifdef CONTACT
        if (sinks && lightHeight + dot(rise, u_kernel[i].xy) < low) {
            sum.covered += 1.0;
            sum.count += 1.0;
            continue;
        }
#endif
        addTo(sum, maskPlace(image, u_kernel[i].xy));
    }
    return sum;
}

void main() {
    vec3 p_world = positionOnRay(v_rayStart, v_rayAlong, gbufferDepth(ivec2(gl_FragCoord.xy)));
    // Tiles that nothing reaches, or nothing but umbra, need no more.
    vec2 uv = (gl_FragCoord.xy * frame.viewport.zw - 0.5) * u_zoom + 0.5;
    vec2 reach = texelFetch(t_reach, ivec2(uv / u_tileInMask), 0).xy;
    Sum sum = Sum(1.0, 1.0, vec3(0.0));
#if STYLE == STYLE_TEXTURED
    sum = covering(p_world, reach.x);
#else
    if (reach.x < 0.0 || reach.y == 0.0) sum = covering(p_world, reach.x);
#endif
    float taken = sum.count > 0.0 ? sum.covered / sum.count : 0.0;
    vec3 caster = sum.color / max(sum.covered, 1e-6);
    vec3 passed = 1.0 - taken * (1.0 - passedByShadow(caster, p_world, u_plane.xyz));
    o_visibility = visibilityOf(passed);
#ifdef COLORED
    o_colored = vec4(passed, 1.0);
#endif
}
