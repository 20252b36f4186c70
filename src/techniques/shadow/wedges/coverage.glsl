// SPDX-License-Identifier: MIT
// Areas of the light's outline D (a unit disk, or the square from -1 to 1) beyond an edge, seen from the middle of D: between
// the edge and the rim, in the sector that the edge spans (Green's theorem; Assarsson and Akenine-Moeller 2003, section 4.3,
// look the same up in a table). All segments are straight and have been projected onto D's plane.
#include "shadow/wedges/light_shape.glsl"

#define IS_RECT LIGHT_IS(LIGHT_RECT)

const float kOutlineArea = IS_RECT ? 4.0 : 3.14159265358979;

float cross2(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

// Keeps of the segment a + t (b - a) what has value(t) >= 0, the value going from v_a to v_b.
void keepPositive(float v_a, float v_b, inout vec2 range) {
    if (v_a < 0.0 && v_b < 0.0) {
        range = vec2(1.0, 0.0);
        return;
    }
    if (v_a < 0.0) range.x = max(range.x, v_a / (v_a - v_b));
    if (v_b < 0.0) range.y = min(range.y, v_a / (v_a - v_b));
}

// The part of a segment inside of D.
vec2 insideOutline(vec2 a, vec2 b) {
    vec2 range = vec2(0.0, 1.0);
    if (IS_RECT) {
        keepPositive(1.0 - a.x, 1.0 - b.x, range);
        keepPositive(1.0 + a.x, 1.0 + b.x, range);
        keepPositive(1.0 - a.y, 1.0 - b.y, range);
        keepPositive(1.0 + a.y, 1.0 + b.y, range);
        return range;
    }
    vec2 d = b - a;
    float length2 = dot(d, d), middle = -dot(a, d);
    float area = cross2(a, d), root2 = length2 - area * area;   // (r |d|)^2 - (distance from the middle times |d|)^2
    if (length2 == 0.0 || root2 <= 0.0) return vec2(1.0, 0.0);
    float root = sqrt(root2);
    return vec2(max(0.0, (middle - root) / length2), min(1.0, (middle + root) / length2));
}

// Disk: between a chord from l to r, counter-clockwise, and the rim. Of a cone both the sector and the triangle from the axis are
// areas on the unit sphere (van Oosterom and Strackee 1983, equation 8), scaled so that the cone's is pi.
float sectorBeyond(vec2 l, vec2 r) {
    float area = cross2(l, r), angle = atan(area, dot(l, r));
    if (g_coneTangent < 1e-3) return 0.5 * (angle - area);
    float t2 = g_coneTangent * g_coneTangent, secant = sqrt(1.0 + t2);
    float lengthL = sqrt(1.0 + t2 * dot(l, l)), lengthR = sqrt(1.0 + t2 * dot(r, r));
    float excess = 2.0 * atan(t2 * area, lengthL * lengthR + lengthL + lengthR + 1.0 + t2 * dot(l, r));
    return 0.5 * (angle - excess * secant * (secant + 1.0) / t2);
}

// Of the straight line at distance d from the middle in the direction n, the part in the sector from l to r (counter-
// clockwise, below pi); as positions along the line.
void keepSector(vec2 n, float d, vec2 l, vec2 r, inout float from, inout float to) {
    vec2 along = vec2(-n.y, n.x), foot = n * d;
    float atL = cross2(l, foot), slopeL = cross2(l, along);   // atL + t slopeL >= 0
    if (slopeL > 0.0) from = max(from, -atL / slopeL);
    else if (slopeL < 0.0) to = min(to, -atL / slopeL);
    else if (atL < 0.0) to = from;
    float atR = cross2(foot, r), slopeR = cross2(along, r);
    if (slopeR > 0.0) from = max(from, -atR / slopeR);
    else if (slopeR < 0.0) to = min(to, -atR / slopeR);
    else if (atR < 0.0) to = from;
}

// Part of D on the far side of the line dot(n, q) = d, d >= 0, in the sector from l to r.
float beyondLine(vec2 n, float d, vec2 l, vec2 r) {
    if (IS_RECT) {
        // What the sector has of the square, less what it has of the square before the line: triangles from the middle
        // to the sides.
        float far = 0.0, near = 0.0;
        const vec2 sides[4] = vec2[](vec2(1, 0), vec2(0, 1), vec2(-1, 0), vec2(0, -1));
        for (int i = 0; i < 4; ++i) {
            float from = -1.0, to = 1.0;
            keepSector(sides[i], 1.0, l, r, from, to);
            if (to <= from) continue;
            far += 0.5 * (to - from);
            vec2 along = vec2(-sides[i].y, sides[i].x);
            float at = d - dot(n, sides[i]), slope = -dot(n, along);   // at + t slope >= 0: before the line
            if (slope > 0.0) from = max(from, -at / slope);
            else if (slope < 0.0) to = min(to, -at / slope);
            else if (at < 0.0) to = from;
            near += 0.5 * max(0.0, to - from);
        }
        float from = -2.0, to = 2.0;
        keepSector(n, d, l, r, from, to);
        vec2 along = vec2(-n.y, n.x);
        vec2 range = insideOutline(n * d + along * from, n * d + along * to);
        return far - near - 0.5 * d * max(0.0, range.y - range.x) * max(0.0, to - from);
    }
    if (d >= 1.0) return 0.0;
    float half_ = sqrt(1.0 - d * d), from = -half_, to = half_;
    keepSector(n, d, l, r, from, to);
    if (to <= from) return 0.0;
    vec2 along = vec2(-n.y, n.x);
    return sectorBeyond(n * d + along * from, n * d + along * to);
}

// Part of D between the segment from l to r, inside of D and counter-clockwise, and the rim.
float beyondSegment(vec2 l, vec2 r) {
    if (!IS_RECT) return sectorBeyond(l, r);
    float area = -0.5 * cross2(l, r);
    const vec2 sides[4] = vec2[](vec2(1, 0), vec2(0, 1), vec2(-1, 0), vec2(0, -1));
    for (int i = 0; i < 4; ++i) {
        float from = -1.0, to = 1.0;
        keepSector(sides[i], 1.0, l, r, from, to);
        area += 0.5 * max(0.0, to - from);
    }
    return area;
}

// Part of D above the horizon.
float aboveHorizon(vec3 horizon) {
    // Beyond the line in the half plane towards it: two sectors of a quarter turn.
    vec2 n = horizon.z >= 0.0 ? -horizon.xy : horizon.xy;
    vec2 along = vec2(-n.y, n.x);
    float d = abs(horizon.z);
    if (d >= 1.5) return horizon.z >= 0.0 ? kOutlineArea : 0.0;
    float beyond = beyondLine(n, d, -along, n) + beyondLine(n, d, n, along);
    return horizon.z >= 0.0 ? kOutlineArea - beyond : beyond;
}

// What the edge from a to b hides or frees: the part of D beyond it and above the horizon, positive where it runs counter-
// clockwise about the middle.
float shareBeyond(vec2 a, vec2 b, vec3 horizon) {
    vec2 range = insideOutline(a, b);
    if (range.y <= range.x) return 0.0;
    vec2 l = mix(a, b, range.x), r = mix(a, b, range.y);
    float orientation = cross2(l, r) < 0.0 ? -1.0 : 1.0;
    if (orientation < 0.0) {
        vec2 swap = l;
        l = r;
        r = swap;
    }
    float whole = beyondSegment(l, r);
    if (abs(horizon.z) >= 1.5) return horizon.z >= 0.0 ? orientation * whole : 0.0;

    // The part of D on the middle's side of the horizon, beyond the edge.
    float side = horizon.z >= 0.0 ? 1.0 : -1.0;
    range = vec2(0.0, 1.0);
    keepPositive(side * (dot(horizon.xy, l) + horizon.z), side * (dot(horizon.xy, r) + horizon.z), range);
    float near = 0.0;
    if (range.y > range.x) {
        vec2 from = mix(l, r, range.x), to = mix(l, r, range.y);
        near = beyondSegment(from, to) - beyondLine(-side * horizon.xy, abs(horizon.z), from, to);
    }
    return orientation * (side > 0.0 ? near : whole - near);
}
