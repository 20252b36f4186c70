// SPDX-License-Identifier: MIT
// The shadow of a light with a size, from the flattened casters' mask and heights. CONTACT: points of the light looked at past a
// caster of the height found around (Fernando 2005, on the plane instead of in a map); else the mask's mean over a disk of one
// width, in metres on the plane or (PIXELS) in the picture. COLORED: the light that passes, in colour, too.
#include "ombrage/gbuffer.glsl"
#include "shadow/planar/penumbra.glsl"
#include "shadow/planar/style.glsl"

layout(binding = 5) uniform sampler2D t_mask;    // x: covered; y: 1 less the height as a share, where covered; with mipmaps
layout(binding = 6) uniform sampler2D t_reach;   // reach.frag
layout(binding = 7) uniform sampler2D t_casterColor;

uniform vec4 u_kernel[SAMPLES];   // xy: even in the unit disk; zw: denser towards the middle
uniform vec2 u_tileInMask;        // a tile's share of the mask
uniform float u_tallest_m;        // height of which the mask holds shares

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

void addTo(inout Sum sum, vec2 uv, float level) {
    if (!isInMask(uv)) return;
    sum.covered += textureLod(t_mask, uv, level).x;
    sum.count += 1.0;
#if defined(COLORED) && STYLE == STYLE_TEXTURED
    sum.color += textureLod(t_casterColor, uv, level).rgb;   // black where nothing covers it
#endif
}

// Pixels of the mask that the disk covers, to first order.
float areaInMask(DiskImage image) {
    vec2 u = image.u.xy - image.centre.xy / image.centre.z * image.u.z, v = image.v.xy - image.centre.xy / image.centre.z * image.v.z;
    vec2 scale = 0.5 * vec2(textureSize(t_mask, 0)) / image.centre.z;
    return 3.14159265 * abs(u.x * v.y - u.y * v.x) * scale.x * scale.y;
}

// The mipmap for samples that stand for that many pixels each, so that none falls between them.
float levelOf(float area_px) { return max(0.0, 0.5 * log2(max(area_px, 1.0)) + -0.5); }

#ifdef CONTACT
// The mean height of the blockers whose own half-shadow reaches the point, at most `highest_m`; less than 0 without any. A place
// of the mask at the share s of the disk belongs to those of the height h where s k(highest) <= k(h).
float blockerHeight(LightDisk disk, vec3 p_world, float lightHeight, float highest_m) {
    float widest = growthAt(highest_m, lightHeight), sum_m = 0.0, blockers = 0.0;
    DiskImage image = blockerImage(disk, p_world, lightHeight, highest_m);
    float area_px = areaInMask(image);
    for (int i = 0; i < SAMPLES; ++i) {
        // A point at the radius r stands for 2 r / SAMPLES of the disk, and takes the mipmap whose texels are as large.
        vec2 uv = maskPlace(image, u_kernel[i].zw);
        if (!isInMask(uv)) continue;
        float radius = length(u_kernel[i].zw);
        vec2 found = textureLod(t_mask, uv, levelOf(area_px * 2.0 * radius / float(SAMPLES))).xy;
        if (found.x <= 0.0) continue;
        float height_m = min((1.0 - found.y / found.x) * u_tallest_m, highest_m);
        if (radius * widest > growthAt(height_m, lightHeight)) continue;
        sum_m += height_m * found.x;
        blockers += found.x;
    }
    return blockers > 0.0 ? sum_m / blockers : -1.0;
}
#endif

#ifdef CONTACT
// The part of the light, seen as a disk, that has sunk under the plane, which blocks it: the sector of a chord at the distance t,
// less its triangle from the centre. Of a cone both are areas on the unit sphere (van Oosterom and Strackee 1983, equation 8).
float sunkShare(LightDisk disk) {
    float rise = length(vec2(dot(u_plane.xyz, disk.u), dot(u_plane.xyz, disk.v)));
    float t = dot(u_plane, u_toward) / max(rise, 1e-20);
    if (t >= 1.0) return 0.0;
    float chord = sqrt(1.0 - t * t), triangle = t * chord;
    if (disk.tangent >= 1e-3) {
        float t2 = disk.tangent * disk.tangent, secant = sqrt(1.0 + t2);
        float excess = 2.0 * atan(2.0 * triangle * t2, 1.0 + t2 + 2.0 * secant + 1.0 + t2 * (t * t - chord * chord));
        triangle = 0.5 * excess / oneMinusCos(disk.tangent);
    }
    return (acos(t) - triangle) / 3.14159265;
}
#endif

Sum covering(vec3 p_world, float highest_m) {
    Sum sum = Sum(0.0, 0.0, vec3(0.0));
#ifdef CONTACT
    float lightHeight = dot(u_plane, u_toward);
    LightDisk disk = lightDisk(p_world);
    vec2 rise = vec2(dot(u_plane.xyz, disk.u), dot(u_plane.xyz, disk.v));
    float height_m = highest_m < 0.0 ? -1.0 : blockerHeight(disk, p_world, lightHeight, highest_m);
    if (height_m < 0.0) return sum;
    DiskImage image = blockerImage(disk, p_world, lightHeight, height_m);
#else
    if (highest_m < 0.0) return sum;
    DiskImage image = constantImage(p_world);
#endif
    float level = levelOf(areaInMask(image) / float(SAMPLES));
    for (int i = 0; i < SAMPLES; ++i) {
        vec2 point = u_kernel[i].xy;
#ifdef CONTACT
        point = evenly(disk, point);
        if (lightHeight + dot(rise, point) <= 0.0) continue;   // sunk
#endif
        addTo(sum, maskPlace(image, point), level);
    }
    return sum;
}

void main() {
    vec3 p_world = positionOnRay(v_rayStart, v_rayAlong, gbufferDepth(ivec2(gl_FragCoord.xy)));
    // Tiles that nothing reaches, or nothing but umbra, need no more.
    vec2 uv = (gl_FragCoord.xy * frame.viewport.zw - 0.5) * u_zoom + 0.5;
    vec2 reach = texelFetch(t_reach, ivec2(uv / u_tileInMask), 0).xy;
    Sum sum = Sum(1.0, 1.0, vec3(0.0));
    float sunk = 0.0;
#ifdef CONTACT
    sunk = sunkShare(lightDisk(p_world));
#endif
    if (STYLE == STYLE_TEXTURED || reach.x < 0.0 || reach.y == 0.0) {
        sum = covering(p_world, reach.x);
    }
    float taken = mix(sum.count > 0.0 ? sum.covered / sum.count : 0.0, 1.0, sunk);
    vec3 caster = sum.color / max(sum.covered, 1e-6);
    vec3 passed = 1.0 - taken * (1.0 - passedByShadow(caster, p_world, u_plane.xyz));
    o_visibility = visibilityOf(passed);
#ifdef COLORED
    o_colored = vec4(passed, 1.0);
#endif
}
