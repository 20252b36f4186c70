// SPDX-License-Identifier: MIT
// The shadow of a light with a size, from the flattened casters' mask and heights. CONSTANT: the mask's mean over a disk of one
// width, in metres on the plane or (PIXELS) in the picture. CONTACT: points of the light looked at past a caster of the height
// found around (Fernando 2005, on the plane instead of in a map). COLORED: the light that passes, in colour, too.
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"
#include "shadow/planar/style.glsl"
#include "shared/light_sampling.glsl"

layout(binding = 5) uniform sampler2D t_mask;   // x: covered, filtered; y: less the height in metres, a texel's own
layout(binding = 6) uniform sampler2D t_casterColor;

uniform vec4 u_kernel[SAMPLES];   // xy: even in the unit disk; zw: denser towards the middle
uniform vec4 u_plane, u_toward;
uniform vec2 u_zoom;              // the picture's share of the mask
uniform float u_radius;           // of the constant disk, in metres or pixels
uniform float u_search_m;         // height of the search: no caster that counts is higher

in vec3 v_rayStart;
in vec3 v_rayAlong;

layout(location = 0) out float o_visibility;
#ifdef COLORED
layout(location = 1) out vec4 o_colored;
#endif

// Place in the mask of a homogeneous point of the plane; outside [0,1] where it is not in the mask.
vec2 maskPlace(vec4 shadow) {
    vec4 clip = frame.clipFromWorld * shadow;
    return clip.w > 0.0 ? clip.xy / clip.w * u_zoom * 0.5 + 0.5 : vec2(-1.0);
}

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
// The light as a disk that faces the point: half axes, as differences of homogeneous places towards it.
struct LightDisk {
    vec3 u, v;
};

LightDisk lightDisk(vec3 p_world) {
    LightDisk disk;
    float radius = light.cone.z;
    if (LIGHT_IS(LIGHT_SPOT)) {
        disk.u = light.tangent.xyz;
        disk.v = light.bitangent.xyz;
    } else if (LIGHT_IS(LIGHT_SUN)) {
        basisOf(u_toward.xyz, disk.u, disk.v);
    } else {
        // The cone about a sphere meets the plane through its centre in a wider disk; within the sphere all is one point.
        vec3 d = light.position.xyz - p_world;
        float distance2 = dot(d, d), rest = distance2 - radius * radius;
        radius *= rest > 0.0 ? sqrt(distance2 / rest) : 0.0;
        basisOf(normalize(d), disk.u, disk.v);
    }
    disk.u *= radius;
    disk.v *= radius;
    return disk;
}

// Where the line from the point to a place of the light is at a height over the plane, flattened like a caster.
vec4 flattenedBlocker(vec3 p_world, vec4 place, float lightHeight, float height_m) {
    float along = height_m / dot(u_plane, place);
    vec3 q_world = p_world + (place.xyz - place.w * p_world) * along;
    return lightHeight * vec4(q_world, 1.0) - height_m * u_toward;
}

vec4 placeOnLight(LightDisk disk, vec2 point) { return u_toward + vec4(disk.u * point.x + disk.v * point.y, 0.0); }

Sum covering(vec3 p_world) {
    Sum sum = Sum(0.0, 0.0, vec3(0.0));
    LightDisk disk = lightDisk(p_world);
    float lightHeight = dot(u_plane, u_toward);
    float low = 1e-4 * lightHeight;
    bool sinks = lightHeight - length(vec2(dot(u_plane.xyz, disk.u), dot(u_plane.xyz, disk.v))) < low;

    // Blockers whose own half-shadow reaches this point: a place of the mask at share s of the disk belongs to the height h
    // where s k(search) <= k(h), with k(h) = h / (H - h w) the growth of the half-shadow.
    float growth = u_search_m / (lightHeight - u_search_m * u_toward.w);
    float heights_m = 0.0, blockers = 0.0;
    for (int i = 0; i < SAMPLES; ++i) {
        vec2 point = u_kernel[i].zw;
        vec4 place = placeOnLight(disk, point);
        if (dot(u_plane, place) < low) continue;
        vec2 uv = maskPlace(flattenedBlocker(p_world, place, lightHeight, u_search_m));
        if (!isInMask(uv)) continue;
        ivec2 size = textureSize(t_mask, 0);
        vec2 found = texelFetch(t_mask, min(ivec2(uv * vec2(size)), size - 1), 0).xy;
        float height_m = -found.y;
        bool reaches = length(point) * growth * (lightHeight - height_m * u_toward.w) <= height_m;
        if (found.x > 0.0 && (reaches || i == 0)) {
            heights_m += height_m;
            blockers += 1.0;
        }
    }
    if (blockers == 0.0 && !sinks) return sum;

    float height_m = blockers > 0.0 ? heights_m / blockers : 0.0;
    for (int i = 0; i < SAMPLES; ++i) {
        vec4 place = placeOnLight(disk, u_kernel[i].xy);
        if (dot(u_plane, place) < low) {
            // What has sunk under the plane is blocked by it.
            sum.covered += 1.0;
            sum.count += 1.0;
        } else {
            addTo(sum, maskPlace(flattenedBlocker(p_world, place, lightHeight, height_m)));
        }
    }
    return sum;
}
#else
Sum covering(vec3 p_world) {
    Sum sum = Sum(0.0, 0.0, vec3(0.0));
#ifdef PIXELS
    vec2 centre = (gl_FragCoord.xy * frame.viewport.zw - 0.5) * u_zoom + 0.5;
    vec2 step_uv = u_radius * frame.viewport.zw * u_zoom;
    for (int i = 0; i < SAMPLES; ++i) addTo(sum, centre + u_kernel[i].xy * step_uv);
#else
    vec3 u, v;
    basisOf(u_plane.xyz, u, v);
    for (int i = 0; i < SAMPLES; ++i)
        addTo(sum, maskPlace(vec4(p_world + (u * u_kernel[i].x + v * u_kernel[i].y) * u_radius, 1.0)));
#endif
    return sum;
}
#endif

void main() {
    vec3 p_world = positionOnRay(v_rayStart, v_rayAlong, gbufferDepth(ivec2(gl_FragCoord.xy)));
    Sum sum = covering(p_world);
    float taken = sum.count > 0.0 ? sum.covered / sum.count : 0.0;
    vec3 caster = sum.color / max(sum.covered, 1e-6);
    vec3 passed = 1.0 - taken * (1.0 - passedByShadow(caster, p_world, u_plane.xyz));
    o_visibility = visibilityOf(passed);
#ifdef COLORED
    o_colored = vec4(passed, 1.0);
#endif
}
