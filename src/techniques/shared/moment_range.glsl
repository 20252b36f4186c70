// SPDX-License-Identifier: MIT
// Depth as the maps of moments hold it (techniques/shared/moment_map.h), and the pixel's axes.
#include "ombrage/frame.glsl"
#include "shared/light_views.glsl"

uniform vec4 u_momentRange;   // metres at z = 0, z per metre, variance of the filter in texels squared, its reach in texels

#ifdef PER_PASS
PER_PASS vec4 momentRange;
PER_PASS vec3 pixelRight;
PER_PASS vec3 pixelUp;
#define MOMENT_RANGE momentRange
#define PIXEL_RIGHT pixelRight
#define PIXEL_UP pixelUp
#else
#define MOMENT_RANGE u_momentRange
#define PIXEL_RIGHT frame.worldFromView[0].xyz
#define PIXEL_UP frame.worldFromView[1].xyz
#endif

#ifdef FULLSCREEN_VERTEX
void passMomentRange() {
    passLightViews();
#ifdef PER_PASS
    momentRange = u_momentRange;
    pixelRight = frame.worldFromView[0].xyz;
    pixelUp = frame.worldFromView[1].xyz;
#endif
}
#endif

// z of a distance along a view's axis.
float momentDepth(float distance_m) { return clamp((distance_m - MOMENT_RANGE.x) * MOMENT_RANGE.y, -1.0, 1.0); }
