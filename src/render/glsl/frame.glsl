// SPDX-License-Identifier: MIT
// The camera. "World" in shaders is the scene's world moved by its floating origin.
#include "ombrage/bindings.glsl"
#include "ombrage/per_pass.glsl"

layout(std140, binding = FRAME_BINDING) uniform Frame {
    mat4 viewFromWorld;
    mat4 clipFromView;
    mat4 clipFromWorld;
    mat4 worldFromView;
    vec4 eye;          // xyz position, w 1 for an orthographic camera
    vec4 forward;      // xyz unit view axis, w the scene's ambient light
    vec4 viewport;     // width, height, 1/width, 1/height in pixels
    vec4 projection;   // near, far (orthographic), half width and half height of the picture at view depth 1 (orthographic: in metres)
    uvec4 random;      // seed, frame index
} frame;

#ifdef PER_PASS
PER_PASS vec4 frameEye;
PER_PASS vec4 frameForward;
PER_PASS vec4 frameViewport;
PER_PASS vec4 frameProjection;
#else
#define frameEye frame.eye
#define frameForward frame.forward
#define frameViewport frame.viewport
#define frameProjection frame.projection
#endif

#ifdef FULLSCREEN_VERTEX
void passFrame() {
#ifdef PER_PASS
    frameEye = frame.eye;
    frameForward = frame.forward;
    frameViewport = frame.viewport;
    frameProjection = frame.projection;
#endif
}
#endif

bool isOrthographic() { return frameEye.w != 0.0; }

// Distance along the view axis from reversed-Z depth in (0,1].
float viewDepthFromDepth(float depth) {
    if (isOrthographic()) return frameProjection.y - depth * (frameProjection.y - frameProjection.x);
    return frameProjection.x / depth;
}

// View space: right-handed, looking along -z. `uv` is (0,0) at the picture's lower left corner.
vec3 positionViewFromDepth(vec2 uv, float depth) {
    float distance_m = viewDepthFromDepth(depth);
    vec2 plane = (uv * 2.0 - 1.0) * frameProjection.zw;
    return vec3(isOrthographic() ? plane : plane * distance_m, -distance_m);
}

// World position from the ray that ombrage/fullscreen.vert hands over.
vec3 positionOnRay(vec3 rayStart, vec3 rayAlong, float depth) { return rayStart + rayAlong * viewDepthFromDepth(depth); }

// Unit vector from a point towards the eye.
vec3 directionToEye(vec3 p_world) {
    return isOrthographic() ? -frameForward.xyz : normalize(frameEye.xyz - p_world);
}

// World size of a pixel at a view depth.
float pixelSizeAt(float viewDepth_m) {
    return 2.0 * frameProjection.w * frameViewport.w * (isOrthographic() ? 1.0 : viewDepth_m);
}
