// SPDX-License-Identifier: MIT
// Where the frame before saw what a pixel shows. Needs ombrage/frame.glsl.
uniform mat4 u_clipNow;      // clip from world of this frame and of the one before, with samples in the pixels' centres
uniform mat4 u_clipBefore;

// What the pixel around `uv` shows, at a depth; the sky is a direction.
vec4 worldOf(vec2 uv, float depth) {
    if (depth > 0.0) return frame.worldFromView * vec4(positionViewFromDepth(uv, depth), 1.0);
    vec2 plane = (uv * 2.0 - 1.0) * frameProjection.zw;
    return vec4(mat3(frame.worldFromView) * vec3(isOrthographic() ? vec2(0.0) : plane, -1.0), 0.0);
}

// How far it has moved over the picture since the frame before, in uv; exactly 0 under a camera that stands still. `wBefore` is its
// distance along the view axis then (perspective; under 0: behind the camera).
vec2 motionOf(vec4 p_world, out float wBefore) {
    vec4 now = u_clipNow * p_world, before = u_clipBefore * p_world;
    wBefore = before.w;
    if (p_world.w == 0.0 && isOrthographic()) return vec2(0.0);
    return 0.5 * (now.xy / now.w - before.xy / before.w);
}
