// SPDX-License-Identifier: MIT
// Emits, in the place of a triangle, the rectangle of tiles around it, and what says which of them it meets: in
// homogeneous coordinates (x, y, w) that need no clipping at the eye's plane (Olano and Greer 1997).
#include "shared/volume_tiles.glsl"

flat out vec3 v_edges[3];      // at least 0 inside, over (x, y, 1); each lies across from its corner
flat out vec3 v_depth;         // depth over (x, y, 1)
flat out vec2 v_depthRange;    // of the triangle
flat out float v_hasRim;       // 1: the edge across from corner 2 is one of the caster's

const float kBehind = 1e-5;    // metres before the eye's plane at which triangles are cut, to find their bounds
const float kBesideEye = 1e-3; // metres; a triangle that comes nearer to the eye may be anywhere
const float kRounding = 1e-6;  // of a corner's place, however far beyond the picture it lies

// What of a triangle lies before the eye's plane, in pixels from the picture's middle.
vec2 s_points[6];
int s_count = 0;
bool s_anywhere = false;

void addPoint(vec2 xy, float w) { s_points[s_count++] = xy / w * 0.5 * frame.viewport.xy; }

void addEdge(vec4 a, vec4 b) {
    if (a.w > kBehind) addPoint(a.xy, a.w);
    if ((a.w > kBehind) == (b.w > kBehind)) return;
    vec2 cut = mix(a.xy, b.xy, (a.w - kBehind) / (a.w - b.w));
    if (max(abs(cut.x), abs(cut.y)) < kBesideEye) s_anywhere = true;
    addPoint(cut, kBehind);
}

// The rectangle around what was added, along the line from its point nearest to the picture's middle to the farthest from
// that, with half a tile around it and no larger than the picture: its middle and its half axes. False: none of it is seen.
bool rectangle(out vec2 middle, out vec2 along, out vec2 aside) {
    float pictureRadius = 0.5 * length(frame.viewport.xy) + float(ONTO_TILES);
    vec2 start = s_points[0];
    for (int i = 1; i < s_count; ++i)
        if (dot(s_points[i], s_points[i]) < dot(start, start)) start = s_points[i];
    vec2 direction = vec2(0.0);
    for (int i = 0; i < s_count; ++i)
        if (dot(s_points[i] - start, s_points[i] - start) > dot(direction, direction)) direction = s_points[i] - start;
    float len = length(direction);
    direction = len > 0.0 ? direction / len : vec2(1.0, 0.0);
    mat2 axes = mat2(direction, vec2(-direction.y, direction.x));

    vec2 lower = vec2(0.0), upper = vec2(0.0);
    for (int i = 0; i < s_count; ++i) {
        vec2 p = (s_points[i] - start) * axes;
        lower = min(lower, p);
        upper = max(upper, p);
    }
    vec2 pictureMiddle = -start * axes;
    float reach = 0.5 * (float(ONTO_TILES) + 2.0) * (abs(direction.x) + abs(direction.y)) + kRounding * (length(start) + len);
    lower = max(lower - reach, pictureMiddle - pictureRadius);
    upper = min(upper + reach, pictureMiddle + pictureRadius);
    if (s_anywhere) {
        lower = pictureMiddle - pictureRadius;
        upper = pictureMiddle + pictureRadius;
    }
    middle = start + axes * (0.5 * (lower + upper));
    along = axes[0] * (0.5 * (upper.x - lower.x));
    aside = axes[1] * (0.5 * (upper.y - lower.y));
    return lower.x < upper.x && lower.y < upper.y;
}

void emitTileBounds(vec4 a, vec4 b, vec4 c, bool hasRim) {
    s_count = 0;
    s_anywhere = false;
    addEdge(a, b);
    addEdge(b, c);
    addEdge(c, a);
    vec2 middle, along, aside;
    if (s_count == 0 || !rectangle(middle, along, aside)) return;

    // Differences first: corners are close to one another, and far from the eye.
    vec3 p = a.xyw, q = b.xyw, r = c.xyw;
    vec3 edges[3] = vec3[3](cross(q, r - q), cross(r, p - r), cross(p, q - p));
    float volume = dot(p, cross(q - p, r - p));
    float side = volume < 0.0 ? -1.0 : 1.0;
    vec3 depth = (edges[0] * a.z + edges[1] * b.z + edges[2] * c.z) / (abs(volume) > 1e-30 ? volume : side * 1e-30);

    // No point of it is deeper than its deepest corner before the eye's plane (depths are reversed, and none is negative).
    vec2 range = vec2(1e30, 0.0);
    vec4 corners[3] = vec4[3](a, b, c);
    for (int i = 0; i < 3; ++i) {
        bool before = corners[i].w > 0.0;
        float d = before ? corners[i].z / corners[i].w : 1e30;
        range = vec2(min(range.x, d), max(range.y, d));
    }

    vec2 scale = tilesScale();
    for (int corner = 0; corner < 4; ++corner) {
        vec2 at = middle + ((corner & 1) != 0 ? along : -along) + ((corner & 2) != 0 ? aside : -aside);
        gl_Position = vec4(at * 2.0 * frame.viewport.zw * scale + (scale - 1.0), 0.5, 1.0);
        for (int i = 0; i < 3; ++i) v_edges[i] = edges[i] * side;
        v_depth = depth;
        v_depthRange = range;
        v_hasRim = hasRim ? 1.0 : 0.0;
        EmitVertex();
    }
    EndPrimitive();
}
