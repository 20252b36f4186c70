// SPDX-License-Identifier: MIT
// Percentage-closer filtering (Reeves, Salesin and Cook 1987): comparisons with many texels about the point, averaged.
#include "shadow/pcf/params"
#include "shared/map_point.glsl"
#include "shared/map_taps.glsl"

#if COMPARE == COMPARE_HARDWARE
#if LIGHT_VIEWS == 1
layout(binding = 5) uniform sampler2DShadow t_map;
#define LIT(uv, view, reference) texture(t_map, vec3(uv, reference))
#else
layout(binding = 5) uniform sampler2DArrayShadow t_map;
#define LIT(uv, view, reference) texture(t_map, vec4(uv, float(view), reference))
#endif
#else
#include "shared/map_texel.glsl"
#if LIGHT_VIEWS == 1
#define STORED(uv, view) texture(t_map, uv).r
#define STORED_FOUR(uv, view) textureGather(t_map, uv)
#else
#define STORED(uv, view) texture(t_map, vec3(uv, float(view))).r
#define STORED_FOUR(uv, view) textureGather(t_map, vec3(uv, float(view)))
#endif
#endif

#if KERNEL == KERNEL_GRID
// A square of SIZE texels, wherever it lies between them: texels at its border count by the part inside.
float litAround(MapPoint at, MapTaps taps, vec2 position, float perResolution) {
    vec2 corner = position - 0.5 * float(SIZE);
    vec2 first = floor(corner), inside = corner - first;
    float sum = 0.0;
    // Four texels at a time: two columns, two rows.
    for (int y = 0; y <= SIZE; y += 2)
        for (int x = 0; x <= SIZE; x += 2) {
            vec2 wx = vec2(x == 0 ? 1.0 - inside.x : x == SIZE ? inside.x : 1.0, x + 1 == SIZE ? inside.x : x + 1 > SIZE ? 0.0 : 1.0);
            vec2 wy = vec2(y == 0 ? 1.0 - inside.y : y == SIZE ? inside.y : 1.0, y + 1 == SIZE ? inside.y : y + 1 > SIZE ? 0.0 : 1.0);
            vec2 middle = vec2(x, y) + 1.0;
#if COMPARE == COMPARE_HARDWARE
            // Between the four where bilinear weights are in proportion to these.
            vec2 whole = vec2(wx.x + wx.y, wy.x + wy.y);
            vec2 between = vec2(wx.y, wy.y) / max(whole, vec2(1e-6)) - 0.5;
            float reference = mapTapOfFour(taps, middle - inside - 0.5 * float(SIZE));
            sum += whole.x * whole.y * LIT((first + middle + between) * perResolution, at.view, reference);
#else
            vec4 stored = STORED_FOUR((first + middle) * perResolution, at.view);
            vec2 offset = middle - inside - 0.5 * float(SIZE);
            vec4 lit = vec4(greaterThanEqual(mapTaps4(taps, offset.x + vec2(-0.5, 0.5), offset.y + vec2(-0.5, 0.5)), stored));
            sum += dot(vec2(lit.w * wx.x + lit.z * wx.y, lit.x * wx.x + lit.y * wx.y), wy);
#endif
        }
    return sum / float(SIZE * SIZE);
}
#else
uniform vec2 u_disk[SAMPLES];   // in the unit disk
#define TURN_BINDING 6
#include "shared/disk_turn.glsl"

float litAround(MapPoint at, MapTaps taps, vec2 position, float perResolution) {
    float angle = 6.28318531 * turnOf(gl_FragCoord.xy);
    vec2 turn = params.radius * vec2(cos(angle), sin(angle));
    float sum = 0.0;
    for (int i = 0; i < SAMPLES; ++i) {
        vec2 place = position + vec2(dot(u_disk[i], vec2(turn.x, -turn.y)), dot(u_disk[i], turn.yx));
#if COMPARE == COMPARE_HARDWARE
        // The four texels around a place meet in one corner.
        sum += LIT(place * perResolution, at.view, mapTapOfFour(taps, floor(place + 0.5) - position));
#else
        vec2 center = floor(place) + 0.5;
        sum += mapTap(taps, center - position) >= STORED(center * perResolution, at.view) ? 1.0 : 0.0;
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
    MapTaps taps = mapTaps(at, reach, perResolution);
    vec2 position = at.uv * resolution;
    // Nothing casts far outside the map, nor where coordinates overflow.
    if (!(abs(position.x) + abs(position.y) < 1e6)) return 1.0;

    // The nearest texel says whether the point is in the light. Only there can a corner darken itself; in the shadow more bias would only leak.
    vec2 center = floor(position) + 0.5;
    float reference = mapTap(taps, center - position);
#if COMPARE == COMPARE_HARDWARE
    float lit = LIT(center * perResolution, at.view, clamp(reference, 0.0, 1.0));
#else
    float stored = STORED(center * perResolution, at.view);
    bool isLit = reference >= stored;
    // In a crease it may show the other surface, which then goes on behind the point.
    if (!isLit) isLit = mapPlaneIsBehind(at, position, ivec2(floor(position)), stored);
    float lit = isLit ? 1.0 : 0.0;
#endif
    allowCorner(taps, at, reach, params.crease, lit);
    return litAround(at, taps, position, perResolution);
}
