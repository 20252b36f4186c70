// SPDX-License-Identifier: MIT
// SMAA 1x, second pass: how much of each pixel lies beyond the true line of its edges (Jimenez et al. 2012, sections 4.2 and 4.3). Out come
// the shares of the pixel that its lower neighbour should have and of the lower neighbour that it should have, and the same to the left.
layout(binding = 5) uniform sampler2D t_edges;           // x: with the left neighbour, y: with the lower one; filtered linearly
layout(binding = 6) uniform sampler2DArray t_area;       // by crossings, roots of both distances
layout(binding = 7) uniform sampler2DArray t_diagonal;   // by ends, both distances
layout(binding = 8) uniform usampler2D t_search;         // pixels of a fetched pair that belong to a run
uniform int u_searchSteps;      // of two pixels each
uniform int u_diagonalSteps;    // 0: diagonals are treated as other edges
uniform float u_cornerWeight;   // of an edge at a corner

layout(location = 0) out vec4 o_weights;

// Both kinds of edges are treated alike: `vertical` changes the roles of the axes. Along is x then, or y; the neighbour is the pixel
// below, or to the left.
ivec2 cellAt(bool vertical, int along, int across) { return vertical ? ivec2(across, along) : ivec2(along, across); }

// Outside of the picture there are no edges.
vec2 edgesAt(ivec2 px) {
    ivec2 size = textureSize(t_edges, 0);
    return any(lessThan(px, ivec2(0))) || any(greaterThanEqual(px, size)) ? vec2(0.0) : texelFetch(t_edges, px, 0).xy;
}

// The edge between a cell and its neighbour, and the one at its start, which crosses the line of the first.
bool edgeAt(ivec2 px, bool vertical, int along, int across) {
    vec2 e = edgesAt(px + cellAt(vertical, along, across));
    return (vertical ? e.x : e.y) > 0.5;
}
bool crossingAt(ivec2 px, bool vertical, int along, int across) {
    vec2 e = edgesAt(px + cellAt(vertical, along, across));
    return (vertical ? e.y : e.x) > 0.5;
}

// Crossings (x) and edges along (y) of a pair of pixels `along` away, as sums of 21, 7, 3 and 1.
ivec2 pairAt(ivec2 px, bool vertical, float along) {
    vec2 at = vec2(along, -0.125);
    vec2 e = texture(t_edges, (vec2(px) + 0.5 + (vertical ? at.yx : at)) / vec2(textureSize(t_edges, 0))).xy;
    return ivec2((vertical ? e.yx : e.xy) * 32.0 + 0.5);
}

// Both pixels of the pair belong to the run, which goes on.
bool goesOn(ivec2 pair) { return pair.x == 0 && pair.y >= 28; }

// How far the run reaches against its axis (x) and along it (y), in pixels beyond px.
ivec2 reachOf(ivec2 px, bool vertical) {
    ivec2 reach = ivec2(-1, 0);
    for (int i = 0; i < u_searchSteps; ++i) {
        ivec2 pair = pairAt(px, vertical, -0.25 - 2.0 * float(i));
        reach.x += int(texelFetch(t_search, pair, 0).x);
        if (!goesOn(pair)) break;
    }
    for (int i = 0; i < u_searchSteps; ++i) {
        ivec2 pair = pairAt(px, vertical, 1.25 + 2.0 * float(i));
        reach.y += int(texelFetch(t_search, pair, 0).y);
        if (!goesOn(pair)) break;
    }
    return reach;
}

// A crossing edge that is two pixels long is a corner of the object, not a step of its outline: each side keeps `u_cornerWeight`, shared
// among the ends by nearness.
vec2 cornersKept(ivec2 px, bool vertical, ivec2 reach) {
    vec2 isNearer = vec2(reach.x <= reach.y, reach.y <= reach.x);
    vec2 lost = (1.0 - u_cornerWeight) * isNearer / (isNearer.x + isNearer.y);
    vec2 kept = vec2(1.0);
    if (crossingAt(px, vertical, -reach.x, 1)) kept.x -= lost.x;
    if (crossingAt(px, vertical, reach.y + 1, 1)) kept.x -= lost.y;
    if (crossingAt(px, vertical, -reach.x, -2)) kept.y -= lost.x;
    if (crossingAt(px, vertical, reach.y + 1, -2)) kept.y -= lost.y;
    return clamp(kept, 0.0, 1.0);
}

vec2 straightAreas(ivec2 px, bool vertical) {
    ivec2 reach = reachOf(px, vertical);
    ivec2 start = ivec2(crossingAt(px, vertical, -reach.x, 0), crossingAt(px, vertical, -reach.x, -1));
    ivec2 end = ivec2(crossingAt(px, vertical, reach.y + 1, 0), crossingAt(px, vertical, reach.y + 1, -1));
    float layer = float(start.x + 2 * start.y + 4 * (end.x + 2 * end.y));
    vec2 areas = textureLod(t_area, vec3((sqrt(vec2(reach)) + 0.5) / vec2(textureSize(t_area, 0).xy), layer), 0.0).xy;
    if (u_cornerWeight < 1.0 && areas != vec2(0.0)) areas *= cornersKept(px, vertical, reach);
    return areas;
}

// The edges of a diagonal run, of which edge 0 is the pixel's own, rising along the axis (side 1) or against it (side -1).
bool stepAlong(ivec2 px, bool vertical, int side, int k) { return edgeAt(px, vertical, side * k, k); }
bool stepAcross(ivec2 px, bool vertical, int side, int k) {
    return crossingAt(px, vertical, side > 0 ? k + 1 : -k, k);
}

// Steps of the diagonal run before (x) and after (y) the pixel's own edge.
ivec2 diagonalReach(ivec2 px, bool vertical, int side) {
    ivec2 reach = ivec2(0);
    for (; reach.x < u_diagonalSteps; ++reach.x)
        if (!stepAcross(px, vertical, side, -reach.x - 1) || !stepAlong(px, vertical, side, -reach.x - 1)) break;
    for (; reach.y < u_diagonalSteps; ++reach.y)
        if (!stepAcross(px, vertical, side, reach.y) || !stepAlong(px, vertical, side, reach.y + 1)) break;
    return reach;
}

// 0 where a run ends in a step like its others, 1 in a long one along the edge, 2 in a long one across it. `k` is the last edge along;
// towards: 1 at the run's end, -1 at its start.
int diagonalEnd(ivec2 px, bool vertical, int side, int k, int towards) {
    int across = towards > 0 ? k : k - 1;
    if (!stepAcross(px, vertical, side, across)) return edgeAt(px, vertical, side * (k + towards), k) ? 1 : 0;
    int column = side > 0 ? across + 1 : -across;
    return crossingAt(px, vertical, column, across + towards) ? 2 : 0;
}

// False where no diagonal of three steps passes.
bool diagonalAreas(ivec2 px, bool vertical, out vec2 areas) {
    ivec2 rising = diagonalReach(px, vertical, 1), falling = diagonalReach(px, vertical, -1);
    bool rises = rising.x + rising.y >= falling.x + falling.y;
    ivec2 reach = rises ? rising : falling;
    areas = vec2(0.0);
    if (reach.x + reach.y < 2) return false;
    int side = rises ? 1 : -1;
    int layer = diagonalEnd(px, vertical, side, -reach.x, -1) + 3 * diagonalEnd(px, vertical, side, reach.y, 1);
    areas = texelFetch(t_diagonal, ivec3(reach, layer), 0).xy;
    return true;
}

vec2 areasOf(ivec2 px, bool vertical) {
    vec2 areas;
    if (u_diagonalSteps > 0 && diagonalAreas(px, vertical, areas)) return areas;
    return straightAreas(px, vertical);
}

void main() {
    ivec2 px = ivec2(gl_FragCoord.xy);
    vec2 edges = texelFetch(t_edges, px, 0).xy;
    o_weights = vec4(0.0);
    if (edges.y > 0.5) o_weights.xy = areasOf(px, false);
    if (edges.x > 0.5) o_weights.zw = areasOf(px, true);
}
