// SPDX-License-Identifier: MIT
// One triangle over the whole viewport, at the depth of the sky, and what its fragments share.
#define FULLSCREEN_VERTEX
#include "ombrage/frame.glsl"
#ifdef LIGHT_TYPE
#include "ombrage/light.glsl"
#endif
#include "ombrage/per_pass_params.glsl"
#include "ombrage/per_pass_lookup.glsl"

noperspective out vec2 v_uv;          // (0,0) lower left, (1,1) upper right
noperspective out vec3 v_rayStart;    // the pixel's ray: p = start + along * distance along the view axis
noperspective out vec3 v_rayAlong;

void main() {
    passFrame();
#ifdef LIGHT_TYPE
    passLight();
#endif
    passParams();
    passLookup();

    vec2 corner = vec2(float((gl_VertexID & 1) << 2), float((gl_VertexID & 2) << 1));
    v_uv = corner * 0.5;
    vec2 plane = (corner - 1.0) * frame.projection.zw;
    vec3 aside = frame.worldFromView[0].xyz * plane.x + frame.worldFromView[1].xyz * plane.y;
    v_rayStart = frame.eye.xyz + (isOrthographic() ? aside : vec3(0.0));
    v_rayAlong = frame.forward.xyz + (isOrthographic() ? vec3(0.0) : aside);
    gl_Position = vec4(corner - 1.0, 0.0, 1.0);
}
