// SPDX-License-Identifier: MIT
// FXAA after Lottes (2009, 2011: version 3.11, quality), from its published description.
#include "aa/fxaa/params"
#include "shared/srgb.glsl"

layout(binding = 5) uniform sampler2D t_picture;   // linear
layout(binding = 6) uniform sampler2D t_encoded;   // encoded, luma in alpha; filtered linearly

noperspective in vec2 v_uv;
layout(location = 0) out vec4 o_color;
#ifdef WRITE_EDGES
layout(location = 1) out float o_edge;
#endif

// Lengths in pixels of the steps along an edge; long last steps guess where the end lies.
#if QUALITY == QUALITY_LOW
const int kStepCount = 3;
const float kSteps[kStepCount] = float[](1.5, 3.0, 12.0);
#elif QUALITY == QUALITY_MEDIUM
const int kStepCount = 5;
const float kSteps[kStepCount] = float[](1.0, 1.5, 2.0, 4.0, 12.0);
#else
const int kStepCount = 12;
const float kSteps[kStepCount] = float[](1.0, 1.0, 1.0, 1.0, 1.0, 1.5, 2.0, 2.0, 2.0, 2.0, 4.0, 8.0);
#endif

float lumaAt(ivec2 px) { return texelFetch(t_encoded, clamp(px, ivec2(0), textureSize(t_encoded, 0) - 1), 0).a; }

// Colour, and the distance in pixels that it was taken from across the edge.
void finish(vec4 color, float moved_px) {
    o_color = color;
#ifdef WRITE_EDGES
    o_edge = moved_px;
#endif
}

void main() {
    ivec2 px = ivec2(gl_FragCoord.xy);
    float middle = lumaAt(px);
    float north = lumaAt(px + ivec2(0, 1)), south = lumaAt(px - ivec2(0, 1));
    float east = lumaAt(px + ivec2(1, 0)), west = lumaAt(px - ivec2(1, 0));

    // Local contrast: pixels without enough of it keep their bits.
    float highest = max(middle, max(max(north, south), max(east, west)));
    float lowest = min(middle, min(min(north, south), min(east, west)));
    float range = highest - lowest;
    if (range < max(params.edge_threshold_min, highest * params.edge_threshold)) {
        finish(texelFetch(t_picture, px, 0), 0.0);
        return;
    }
    float northEast = lumaAt(px + ivec2(1, 1)), northWest = lumaAt(px + ivec2(-1, 1));
    float southEast = lumaAt(px + ivec2(1, -1)), southWest = lumaAt(px + ivec2(-1, -1));

    // Detail below a pixel: how far the middle is from the mean of its 3x3 neighbourhood, as a share of the contrast.
    float mean = (2.0 * (north + south + east + west) + northEast + northWest + southEast + southWest) / 12.0;
    float detail = smoothstep(0.0, 1.0, abs(mean - middle) / range);
    float subpixel_px = detail * detail * params.subpix;

    // The edge runs along the axis across which luma bends less.
    float bendVertical = 2.0 * abs(north + south - 2.0 * middle) + abs(northEast + southEast - 2.0 * east) +
                         abs(northWest + southWest - 2.0 * west);
    float bendHorizontal = 2.0 * abs(east + west - 2.0 * middle) + abs(northEast + northWest - 2.0 * north) +
                           abs(southEast + southWest - 2.0 * south);
    bool horizontal = bendVertical >= bendHorizontal;

    // Of the two sides of the pixel the steeper one is the edge.
    float ahead = horizontal ? north : east, behind = horizontal ? south : west;
    float stepAhead = abs(ahead - middle), stepBehind = abs(behind - middle);
    bool isAhead = stepAhead > stepBehind;
    float steepness = max(stepAhead, stepBehind);
    float edgeLuma = 0.5 * (middle + (isAhead ? ahead : behind));

    // Walk between the two rows of pixels, both ways at once, until the pair's luma leaves the edge's.
    vec2 texel = 1.0 / vec2(textureSize(t_encoded, 0));
    vec2 across = (horizontal ? vec2(0.0, texel.y) : vec2(texel.x, 0.0)) * (isAhead ? 1.0 : -1.0);
    vec2 along = horizontal ? vec2(texel.x, 0.0) : vec2(0.0, texel.y);
    vec2 start = v_uv + 0.5 * across;
    float enough = 0.25 * steepness;
    float forward_px = 0.0, backward_px = 0.0, forwardEnd = 0.0, backwardEnd = 0.0;
    bool forwardDone = false, backwardDone = false;
    for (int i = 0; i < kStepCount && !(forwardDone && backwardDone); ++i) {
        if (!forwardDone) {
            forward_px += kSteps[i];
            forwardEnd = textureLod(t_encoded, start + along * forward_px, 0.0).a - edgeLuma;
            forwardDone = abs(forwardEnd) >= enough;
        }
        if (!backwardDone) {
            backward_px += kSteps[i];
            backwardEnd = textureLod(t_encoded, start - along * backward_px, 0.0).a - edgeLuma;
            backwardDone = abs(backwardEnd) >= enough;
        }
    }

    // A slanted edge crosses this pixel's row by the nearer end only if that end lies on the other side than the pixel.
    bool forwardNearer = forward_px < backward_px;
    float nearest_px = min(forward_px, backward_px), span_px = forward_px + backward_px;
    float end = forwardNearer ? forwardEnd : backwardEnd;
    bool crosses = (end < 0.0) != (middle - edgeLuma < 0.0);
    float edge_px = crosses ? 0.5 - nearest_px / span_px : 0.0;

    float moved_px = max(edge_px, subpixel_px);
    if (moved_px == 0.0) {
        finish(texelFetch(t_picture, px, 0), 0.0);
        return;
    }
    vec3 blended = textureLod(t_encoded, v_uv + moved_px * across, 0.0).rgb;
    finish(vec4(linearFromSrgb(blended), texelFetch(t_picture, px, 0).a), moved_px);
}
