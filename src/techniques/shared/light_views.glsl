// SPDX-License-Identifier: MIT
// The views of one light: techniques/shared/light_views.h. LIGHT_VIEWS: 1 or 6; LIGHT_PERSPECTIVE: 0 or 1. Both are known to the
// compiler, so that a single view costs no indexing. LIGHT_PARABOLOIDS: 2 views, LIGHT_TETRAHEDRON: 4 in two layers.
#include "ombrage/per_pass.glsl"

uniform vec4 u_viewOrigin[LIGHT_VIEWS];    // xyz, w far
uniform vec4 u_viewRight[LIGHT_VIEWS];     // xyz, w half extent
uniform vec4 u_viewUp[LIGHT_VIEWS];        // xyz, w half extent
uniform vec4 u_viewForward[LIGHT_VIEWS];   // xyz, w near
#ifdef LIGHT_TETRAHEDRON
uniform vec4 u_viewRays[3 * LIGHT_VIEWS];  // xyz of each view: ray = [0] x + [1] y + [2] for a point of the picture, [-1,1]
#endif

#if defined(PER_PASS) && LIGHT_VIEWS == 1
PER_PASS vec4 lightViewOrigin;
PER_PASS vec4 lightViewRight;
PER_PASS vec4 lightViewUp;
PER_PASS vec4 lightViewForward;
PER_PASS vec3 lightViewScales;   // 1 / half extents, 1 / depth range
#define VIEW_ORIGIN(view) lightViewOrigin
#define VIEW_RIGHT(view) lightViewRight
#define VIEW_UP(view) lightViewUp
#define VIEW_FORWARD(view) lightViewForward
#define VIEW_SCALES(view) lightViewScales
#else
#define VIEW_ORIGIN(view) u_viewOrigin[view]
#define VIEW_RIGHT(view) u_viewRight[view]
#define VIEW_UP(view) u_viewUp[view]
#define VIEW_FORWARD(view) u_viewForward[view]
#define VIEW_SCALES(view) lightViewScalesOf(view)
#endif

vec3 lightViewScalesOf(int view) {
    return 1.0 / vec3(u_viewRight[view].w, u_viewUp[view].w, u_viewOrigin[view].w - u_viewForward[view].w);
}

#ifdef FULLSCREEN_VERTEX
void passLightViews() {
#if LIGHT_VIEWS == 1
    lightViewOrigin = u_viewOrigin[0];
    lightViewRight = u_viewRight[0];
    lightViewUp = u_viewUp[0];
    lightViewForward = u_viewForward[0];
    lightViewScales = lightViewScalesOf(0);
#endif
}
#endif

// Which of the views sees a point: the only one, or the cube face of its largest coordinate (+x -x +y -y +z -z), the paraboloid on
// its side, the tetrahedron's face before it.
int lightViewOf(vec3 p_world) {
#if LIGHT_VIEWS == 1
    return 0;
#elif defined(LIGHT_PARABOLOIDS)
    return dot(p_world - VIEW_ORIGIN(0).xyz, VIEW_FORWARD(0).xyz) >= 0.0 ? 0 : 1;
#elif defined(LIGHT_TETRAHEDRON)
    vec3 d = p_world - VIEW_ORIGIN(0).xyz;
    vec4 along = vec4(dot(d, VIEW_FORWARD(0).xyz), dot(d, VIEW_FORWARD(1).xyz), dot(d, VIEW_FORWARD(2).xyz), dot(d, VIEW_FORWARD(3).xyz));
    vec2 most = max(along.xz, along.yw);
    if (most.x >= most.y) return along.x >= along.y ? 0 : 1;
    return along.z >= along.w ? 2 : 3;
#else
    vec3 d = p_world - VIEW_ORIGIN(0).xyz;
    vec3 a = abs(d);
    if (a.x >= a.y && a.x >= a.z) return d.x >= 0.0 ? 0 : 1;
    if (a.y >= a.z) return d.y >= 0.0 ? 2 : 3;
    return d.z >= 0.0 ? 4 : 5;
#endif
}

// The layer of the map that holds a view.
int lightViewLayer(int view) {
#ifdef LIGHT_TETRAHEDRON
    return view >> 1;
#else
    return view;
#endif
}

#ifdef LIGHT_PARABOLOIDS
// The unit direction, in the world's axes, that a paraboloid shows at a point of its picture.
vec3 lightViewParaboloidRay(int view, vec2 uv) {
    vec2 xy = (uv * 2.0 - 1.0) * VIEW_RIGHT(view).w;
    float square = dot(xy, xy);
    return (2.0 * (VIEW_RIGHT(view).xyz * xy.x + VIEW_UP(view).xyz * xy.y) + VIEW_FORWARD(view).xyz * (1.0 - square)) / (1.0 + square);
}
#endif

// Coordinates in the map, [0,1] inside, and the distance along the view's axis (from the light where it is a paraboloid's).
vec2 lightViewUv(int view, vec3 p_world, out float distance_m) {
    vec3 d = p_world - VIEW_ORIGIN(view).xyz;
#ifdef LIGHT_PARABOLOIDS
    // Brabec, Annen and Seidel 2002, equation 2.
    distance_m = length(d);
    vec2 lateral = vec2(dot(d, VIEW_RIGHT(view).xyz), dot(d, VIEW_UP(view).xyz));
    return lateral / (distance_m + dot(d, VIEW_FORWARD(view).xyz)) * VIEW_SCALES(view).xy * 0.5 + 0.5;
#else
    distance_m = dot(d, VIEW_FORWARD(view).xyz);
    vec2 xy = vec2(dot(d, VIEW_RIGHT(view).xyz), dot(d, VIEW_UP(view).xyz)) * VIEW_SCALES(view).xy;
    if (LIGHT_PERSPECTIVE != 0) xy /= distance_m;
    return xy * 0.5 + 0.5;
#endif
}

// Distance along the axis at which the ray of the map's point `uv` meets the plane through p with normal n, or
// `otherwise` when it runs along the plane.
float lightViewPlaneDistance(int view, vec2 uv, vec3 p_world, vec3 n_world, float otherwise) {
    vec3 start = VIEW_ORIGIN(view).xyz;
#if defined(LIGHT_PARABOLOIDS)
    vec3 direction = lightViewParaboloidRay(view, uv);
#elif defined(LIGHT_TETRAHEDRON)
    vec2 xy = uv * 2.0 - 1.0;
    vec3 direction = u_viewRays[3 * view].xyz * xy.x + u_viewRays[3 * view + 1].xyz * xy.y + u_viewRays[3 * view + 2].xyz;
#else
    vec2 xy = (uv * 2.0 - 1.0) * vec2(VIEW_RIGHT(view).w, VIEW_UP(view).w);
    vec3 lateral = VIEW_RIGHT(view).xyz * xy.x + VIEW_UP(view).xyz * xy.y;
    vec3 direction = VIEW_FORWARD(view).xyz;
    if (LIGHT_PERSPECTIVE != 0) direction += lateral; else start += lateral;
#endif
    float slope = dot(n_world, direction);
    if (abs(slope) < 1e-6) return otherwise;
    return dot(n_world, p_world - start) / slope;
}

// World size of a texel, across the light's rays.
float lightViewTexel(int view, float distance_m, float perResolution) {
    float texel = 2.0 * max(VIEW_RIGHT(view).w, VIEW_UP(view).w) * perResolution;
    return LIGHT_PERSPECTIVE != 0 ? texel * distance_m : texel;
}

// The same at a point of the map: a paraboloid's are twice as large in the middle as at the rim.
float lightViewTexelAt(int view, vec2 uv, float distance_m, float perResolution) {
#ifdef LIGHT_PARABOLOIDS
    vec2 xy = (uv * 2.0 - 1.0) * VIEW_RIGHT(view).w;
    return lightViewTexel(view, distance_m, perResolution) * 2.0 / (1.0 + dot(xy, xy));
#else
    return lightViewTexel(view, distance_m, perResolution);
#endif
}

// What the map holds at a distance along the axis.
float lightViewDepth(int view, float distance_m) {
    float near_m = VIEW_FORWARD(view).w;
    if (LIGHT_PERSPECTIVE != 0) return distance_m > near_m ? near_m / distance_m : 1.0;
    return (VIEW_ORIGIN(view).w - distance_m) * VIEW_SCALES(view).z;
}

// The distance along the axis that the map holds as `depth`, more than 0.
float lightViewDistance(int view, float depth) {
    float near_m = VIEW_FORWARD(view).w, far_m = VIEW_ORIGIN(view).w;
    return LIGHT_PERSPECTIVE != 0 ? near_m / depth : far_m - depth * (far_m - near_m);
}

// Smallest difference of distances that the map can tell at a distance: a few units in the last place of its float depth, or
// one of MAP_BITS bits, which in near/d is worth the more the farther away.
float lightViewPrecision(int view, float distance_m) {
    float range = LIGHT_PERSPECTIVE != 0 ? distance_m : VIEW_ORIGIN(view).w - VIEW_FORWARD(view).w;
#ifdef MAP_BITS
    float unit = exp2(-float(MAP_BITS)) * (LIGHT_PERSPECTIVE != 0 ? max(distance_m / VIEW_FORWARD(view).w, 1.0) : 1.0);
    return range * (4e-7 + unit);
#else
    return range * 4e-7;
#endif
}

// Smallest difference of two depths that the map can tell.
float mapDepthUnit(float depth) {
#ifdef MAP_BITS
    return exp2(-float(MAP_BITS));
#else
    return depth * 1.2e-7;
#endif
}
