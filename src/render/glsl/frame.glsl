// SPDX-License-Identifier: MIT
// The camera. "World" in shaders is the scene's world moved by its floating origin.
#include "ombrage/bindings.glsl"

layout(std140, binding = FRAME_BINDING) uniform Frame {
    mat4 viewFromWorld;
    mat4 clipFromView;
    mat4 clipFromWorld;
    mat4 worldFromView;
    vec4 eye;          // xyz position, w 1 for an orthographic camera
    vec4 forward;      // xyz unit view axis
    vec4 viewport;     // width, height, 1/width, 1/height in pixels
    vec4 projection;   // near, far (orthographic), half width and half height of the picture at view depth 1 (orthographic: in metres)
    uvec4 random;      // seed, frame index
} frame;

bool isOrthographic() { return frame.eye.w != 0.0; }

// Distance along the view axis from reversed-Z depth in (0,1].
float viewDepthFromDepth(float depth) {
    if (isOrthographic()) return frame.projection.y - depth * (frame.projection.y - frame.projection.x);
    return frame.projection.x / depth;
}

// View space: right-handed, looking along -z. `uv` is (0,0) at the picture's lower left corner.
vec3 positionViewFromDepth(vec2 uv, float depth) {
    float distance_m = viewDepthFromDepth(depth);
    vec2 plane = (uv * 2.0 - 1.0) * frame.projection.zw;
    return vec3(isOrthographic() ? plane : plane * distance_m, -distance_m);
}

// World position from the ray that ombrage/fullscreen.vert hands over.
vec3 positionOnRay(vec3 rayStart, vec3 rayAlong, float depth) { return rayStart + rayAlong * viewDepthFromDepth(depth); }

// Unit vector from a point towards the eye.
vec3 directionToEye(vec3 p_world) {
    return isOrthographic() ? -frame.forward.xyz : normalize(frame.eye.xyz - p_world);
}

// World size of a pixel at a view depth.
float pixelSizeAt(float viewDepth_m) {
    return 2.0 * frame.projection.w * frame.viewport.w * (isOrthographic() ? 1.0 : viewDepth_m);
}
