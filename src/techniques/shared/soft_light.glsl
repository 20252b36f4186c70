// SPDX-License-Identifier: MIT
// A light with a size as a receiver sees it through the light's map. Include shared/map_point.glsl first, and define PYRAMID_BINDING.
//
// Closeness is the measure of depth along the view's axis in which everything is linear: 1/z for perspective views, -z for orthographic ones.
// The ray from the receiver to a point of the light leaves, at a closeness c, the receiver's place in the map by a distance that grows in
// proportion to c - c_receiver: Fernando's similar triangles, light size * (d_receiver - d_blocker) / d_blocker.
#include "shared/depth_pyramid.glsl"
#include "shared/light_sampling.glsl"

// The light's outline, a disk (|u| <= 1) or a rectangle (max |u| <= 1), about the light's centre. Spheres and suns are the disk that their cone of
// directions cuts out.
struct LightShape {
    vec3 axisX, axisY;   // half axes in metres; of a sun at distance 1
    vec3 toCentre;       // from the receiver; of a sun at distance 1
};

LightShape lightShapeFrom(vec3 p_world) {
    LightShape shape;
    if (LIGHT_IS(LIGHT_SUN)) {
        shape.toCentre = -lightDirection.xyz;
        basisOf(shape.toCentre, shape.axisX, shape.axisY);
        shape.axisX *= lightCone.z;
        shape.axisY *= lightCone.z;
        return shape;
    }
    shape.toCentre = lightPosition.xyz - p_world;
    if (LIGHT_IS(LIGHT_POINT)) {
        float distance2 = dot(shape.toCentre, shape.toCentre), radius2 = lightCone.z * lightCone.z;
        basisOf(shape.toCentre * inversesqrt(distance2), shape.axisX, shape.axisY);
        // What the cone cuts out of the plane through the centre; from within the sphere no more than at its rim.
        float radius = lightCone.z * sqrt(distance2 / max(distance2 - radius2, 0.01 * distance2));
        shape.axisX *= radius;
        shape.axisY *= radius;
        return shape;
    }
    // A side of no length gets a little, so that it can be divided by.
    vec2 halfSize = LIGHT_IS(LIGHT_RECT) ? vec2(light.tangent.w, light.bitangent.w) : vec2(lightCone.z);
    halfSize = max(halfSize, 1e-3 * max(halfSize.x, halfSize.y));
    shape.axisX = light.tangent.xyz * halfSize.x;
    shape.axisY = light.bitangent.xyz * halfSize.y;
    return shape;
}

// The part of a light's outline above the receiver's plane is where this is positive.
float aboveHorizon(LightShape shape, vec3 n_world, vec2 u) {
    return dot(n_world, shape.toCentre) + u.x * dot(n_world, shape.axisX) + u.y * dot(n_world, shape.axisY);
}

// 1 at the outline.
float outlineNorm(vec2 u) { return LIGHT_IS(LIGHT_RECT) ? max(abs(u.x), abs(u.y)) : length(u); }

// The outline, seen from the receiver, in the map.
struct LightInMap {
    float closeness;        // of the receiver
    mat2 texelsFromLight;   // texels for each unit of closeness
    mat2 lightFromTexels;
    vec2 tilt;              // of the outline against the view's plane
    vec2 extent_texels;     // of the outline's bounds, for each unit of closeness
};

float closenessAt(float distance_m) { return LIGHT_PERSPECTIVE != 0 ? 1.0 / distance_m : -distance_m; }

// From what the map holds.
float closenessOfDepth(int view, float depth) {
    if (LIGHT_PERSPECTIVE != 0) return depth / VIEW_FORWARD(view).w;
    return depth / VIEW_SCALES(view).z - VIEW_ORIGIN(view).w;
}

vec3 inViewAxes(int view, vec3 v) { return vec3(dot(v, VIEW_RIGHT(view).xyz), dot(v, VIEW_UP(view).xyz), dot(v, VIEW_FORWARD(view).xyz)); }

LightInMap lightInMap(MapPoint at, LightShape shape, float resolution) {
    LightInMap seen;
    seen.closeness = closenessAt(at.distance_m);
    vec3 x = inViewAxes(at.view, shape.axisX), y = inViewAxes(at.view, shape.axisY);
    seen.tilt = vec2(0.0);
    if (LIGHT_PERSPECTIVE != 0) {
        // A point of the light that is not in the plane through the centre is moved there along its ray to the receiver.
        vec2 p = inViewAxes(at.view, -shape.toCentre).xy / at.distance_m;
        seen.tilt = vec2(x.z, y.z) / at.distance_m;
        x.xy -= p * x.z;
        y.xy -= p * y.z;
    }
    vec2 scale = 0.5 * resolution * VIEW_SCALES(at.view).xy;
    seen.texelsFromLight = mat2(x.xy * scale, y.xy * scale);
    float determinant = determinant(seen.texelsFromLight);
    // Where the outline is seen edge-on its width is as good as none.
    float least = 1e-6 * (dot(seen.texelsFromLight[0], seen.texelsFromLight[0]) + dot(seen.texelsFromLight[1], seen.texelsFromLight[1]));
    if (abs(determinant) < least) determinant = determinant < 0.0 ? -least : least;
    seen.lightFromTexels =
        mat2(seen.texelsFromLight[1].y, -seen.texelsFromLight[0].y, -seen.texelsFromLight[1].x, seen.texelsFromLight[0].x) / determinant;
    vec2 a = abs(seen.texelsFromLight[0]), b = abs(seen.texelsFromLight[1]);
    seen.extent_texels = LIGHT_IS(LIGHT_RECT) ? a + b : sqrt(a * a + b * b);
    // The side that is tilted towards the receiver looks larger.
    seen.extent_texels /= 1.0 - min(abs(seen.tilt.x) + abs(seen.tilt.y), 0.9);
    return seen;
}

// Where, in texels from the receiver, its ray to a point of the outline is at a closeness that is so much more than the receiver's.
vec2 texelsOf(LightInMap seen, vec2 u, float closer) {
    return seen.texelsFromLight * u * (closer / max(1.0 - dot(seen.tilt, u), 0.1));
}

// Whether what lies so many texels from the receiver, and is so much closer to the light, is between the receiver and the light.
// @param margin_texels beyond which it may be
bool isBeforeLight(LightInMap seen, vec2 beside, float closer, float margin_texels) {
    float apart = length(beside);
    vec2 w = seen.lightFromTexels * (beside * (max(apart - margin_texels, 0.0) / max(apart, 1e-6)));
    // u = w / (closer + tilt.w), without the division.
    return outlineNorm(w) <= max(closer + dot(seen.tilt, w), 0.0);
}

// How much closer to the light than the receiver the nearest can be that lies between it and the light. What is nearest in the whole map
// says how far from the receiver to look, and what is nearest there says it better (Guennebaud et al. 2006, section 4.2).
// @param limit of the answer; @param margin_texels to look farther
float nearestBeforeLight(MapPoint at, LightInMap seen, float resolution, float limit, float margin_texels) {
    float closer = min(closenessOfDepth(at.view, pyramidTop(at.view).x) - seen.closeness, limit);
    vec2 here = at.uv * resolution;
    for (int i = 0; i < 4 && closer > 0.0; ++i) {
        vec2 reach = seen.extent_texels * closer + margin_texels;
        float there = closenessOfDepth(at.view, pyramidAround(at.view, here - reach, here + reach, resolution).x) - seen.closeness;
        bool isMuchLess = there < 0.8 * closer;
        closer = min(closer, there);
        if (!isMuchLess) break;
    }
    return closer;
}
