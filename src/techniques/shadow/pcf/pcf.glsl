// SPDX-License-Identifier: MIT
// Percentage-closer filtering (Reeves, Salesin and Cook 1987): comparisons with many texels about the point, averaged.
#include "shadow/pcf/params"
#include "shared/map_point.glsl"

#if COMPARE == COMPARE_HARDWARE
#if LIGHT_VIEWS == 1
layout(binding = 5) uniform sampler2DShadow t_map;
#else
layout(binding = 5) uniform sampler2DArrayShadow t_map;
#endif
#else
#if LIGHT_VIEWS == 1
layout(binding = 5) uniform sampler2D t_map;
#else
layout(binding = 5) uniform sampler2DArray t_map;
#endif
#endif

// In a concave corner of a right angle the other surface lies before this one's plane by slope + 1/slope for each unit aside: texels farther
// aside than the nearest one get as much more bias, so that walls do not darken floors. Limited, as contacts lose their shadow there.
float creaseBias(MapPoint at, vec2 beside) {
    if (max(beside.x, beside.y) <= 0.5) return 0.0;
    return min(at.slope + 1.0 / max(at.slope, 1e-3), params.crease) * length(beside) * at.texel_m;
}

float tapReference(MapPoint at, vec2 center, vec2 beside) {
    return clamp(lightViewDepth(at.view, mapDistance(at, center, beside) - creaseBias(at, beside)), 0.0, 1.0);
}

// The share of four texels around a point of the map that are lit, by the distances to it, against one depth.
#if COMPARE == COMPARE_HARDWARE
float litAround(MapPoint at, vec2 uv, vec2 beside) {
    // The farthest of the four lies a texel away.
    float reference = mapReference(at, uv, beside + 1.0);
#if BIAS == BIAS_ADAPTIVE || BIAS == BIAS_RECEIVER_PLANE
    reference = clamp(lightViewDepth(at.view, mapDistance(at, uv, beside) - at.texel_m * at.slope), 0.0, 1.0);
#endif
#if LIGHT_VIEWS == 1
    return texture(t_map, vec3(uv, reference));
#else
    return texture(t_map, vec4(uv, float(at.view), reference));
#endif
}
#endif

#if KERNEL == KERNEL_GRID
// A square of SIZE texels, wherever it lies between them: texels at its border count by the part inside.
float litOf(MapPoint at, float resolution, float perResolution) {
#if COMPARE == COMPARE_HARDWARE
    float sum = 0.0;
    for (int y = 0; y < SIZE; ++y)
        for (int x = 0; x < SIZE; ++x) {
            vec2 beside = vec2(x, y) - 0.5 * float(SIZE - 1);
            sum += litAround(at, at.uv + beside * perResolution, abs(beside));
        }
    return sum / float(SIZE * SIZE);
#else
    vec2 corner = at.uv * resolution - 0.5 * float(SIZE);
    vec2 first = floor(corner), inside = corner - first;
    float sum = 0.0;
    // Four texels at a time.
    for (int y = 0; y <= SIZE; y += 2)
        for (int x = 0; x <= SIZE; x += 2) {
            vec2 middle = first + vec2(x, y) + 1.0;
#if LIGHT_VIEWS == 1
            vec4 stored = textureGather(t_map, middle * perResolution);
#else
            vec4 stored = textureGather(t_map, vec3(middle * perResolution, float(at.view)));
#endif
            vec2 wx = vec2(x == 0 ? 1.0 - inside.x : x == SIZE ? inside.x : 1.0, x + 1 == SIZE ? inside.x : x + 1 > SIZE ? 0.0 : 1.0);
            vec2 wy = vec2(y == 0 ? 1.0 - inside.y : y == SIZE ? inside.y : 1.0, y + 1 == SIZE ? inside.y : y + 1 > SIZE ? 0.0 : 1.0);
            const vec2 kTexels[4] = vec2[](vec2(-0.5, 0.5), vec2(0.5, 0.5), vec2(0.5, -0.5), vec2(-0.5, -0.5));
            vec4 weights = vec4(wx.x * wy.y, wx.y * wy.y, wx.y * wy.x, wx.x * wy.x);
            for (int k = 0; k < 4; ++k) {
                vec2 center = (middle + kTexels[k]) * perResolution;
                float reference = tapReference(at, center, abs(center - at.uv) * resolution);
                sum += reference >= stored[k] ? weights[k] : 0.0;
            }
        }
    return sum / float(SIZE * SIZE);
#endif
}
#else
uniform vec2 u_disk[SAMPLES];   // in the unit disk
#define TURN_BINDING 6
#include "shared/disk_turn.glsl"

float litOf(MapPoint at, float resolution, float perResolution) {
    float angle = 6.28318531 * turnOf(gl_FragCoord.xy);
    vec2 turn = params.radius * vec2(cos(angle), sin(angle));
    float sum = 0.0;
    for (int i = 0; i < SAMPLES; ++i) {
        vec2 beside = vec2(dot(u_disk[i], vec2(turn.x, -turn.y)), dot(u_disk[i], turn.yx));
        vec2 uv = at.uv + beside * perResolution;
#if COMPARE == COMPARE_HARDWARE
        sum += litAround(at, uv, abs(beside));
#else
        vec2 center = (floor(uv * resolution) + 0.5) * perResolution;
        float reference = tapReference(at, center, abs(center - at.uv) * resolution);
#if LIGHT_VIEWS == 1
        sum += reference >= texture(t_map, center).r ? 1.0 : 0.0;
#else
        sum += reference >= texture(t_map, vec3(center, float(at.view))).r ? 1.0 : 0.0;
#endif
#endif
    }
    return sum / float(SAMPLES);
}
#endif

float shadowVisibility(vec3 p_world, vec3 n_world) {
    float resolution = float(textureSize(t_map, 0).x), perResolution = 1.0 / resolution;
#if KERNEL == KERNEL_GRID
    float reach = 0.5 * float(SIZE);
#else
    float reach = params.radius;
#endif
    MapPoint at;
    if (!mapPoint(p_world, n_world, reach, perResolution, at)) return 1.0;
    return litOf(at, resolution, perResolution);
}
