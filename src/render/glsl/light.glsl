// SPDX-License-Identifier: MIT
// One light and its unshadowed irradiance.
#include "ombrage/bindings.glsl"
#include "ombrage/per_pass.glsl"

#define LIGHT_SUN 0
#define LIGHT_SPOT 1
#define LIGHT_POINT 2
#define LIGHT_RECT 3

// With LIGHT_TYPE the bound light is of that type, and the compiler drops the others' work.
#ifdef LIGHT_TYPE
#define LIGHT_IS(type) (LIGHT_TYPE == (type))
#else
#define LIGHT_IS(type) (int(lightColor.w) == (type))
#endif

layout(std140, binding = LIGHT_BINDING) uniform LightBlock {
    vec4 position;    // xyz of the centre; w 0 for a sun, else 1
    vec4 direction;   // xyz where light travels; w range in metres (huge when there is none)
    vec4 color;       // rgb times intensity; w type
    vec4 cone;        // cosine of the inner and the outer half angle; z radius in metres (sun: tangent of half its angle); w area of a rect
    vec4 tangent;     // xyz unit; w half size along it
    vec4 bitangent;   // xyz unit; w half size along it
    uvec4 exclusion;  // x first word of this light in b_exclusions, y 1 when it excludes anything
} light;

#if defined(PER_PASS) && defined(LIGHT_TYPE)
PER_PASS vec4 lightPosition;
PER_PASS vec4 lightDirection;
PER_PASS vec4 lightColor;
PER_PASS vec4 lightCone;
#else
#define lightPosition light.position
#define lightDirection light.direction
#define lightColor light.color
#define lightCone light.cone
#endif

#ifdef FULLSCREEN_VERTEX
void passLight() {
#ifdef PER_PASS
    lightPosition = light.position;
    lightDirection = light.direction;
    lightColor = light.color;
    lightCone = light.cone;
#endif
}
#endif

layout(std430, binding = EXCLUSION_STORAGE) readonly buffer Exclusions { uint b_exclusions[]; };

// Whether the light leaves this instance out: it neither lights nor shades it.
bool lightExcludes(uint instance) {
    return light.exclusion.y != 0u && (b_exclusions[light.exclusion.x + instance / 32u] >> (instance % 32u) & 1u) != 0u;
}

// Unit direction to the light's centre and the distance (huge for a sun).
vec3 directionToLight(vec3 p_world, out float distance_m) {
    if (LIGHT_IS(LIGHT_SUN)) {
        distance_m = 1e30;
        return -lightDirection.xyz;
    }
    vec3 d = lightPosition.xyz - p_world;
    distance_m = length(d);
    return d / distance_m;
}

// Irradiance on a surface that faces the light squarely, all visibility left out. The light counts as its centre.
vec3 irradianceFacing(vec3 l, float distance_m) {
    if (!LIGHT_IS(LIGHT_SUN) && distance_m > lightDirection.w) return vec3(0.0);
    float factor = 1.0;
    if (!LIGHT_IS(LIGHT_SUN)) factor /= distance_m * distance_m;
    float alongAxis = dot(-l, lightDirection.xyz);
    if (LIGHT_IS(LIGHT_SPOT)) {
        // The squared ramp between the cosines of KHR_lights_punctual.
        float ramp = clamp((alongAxis - lightCone.y) / max(lightCone.x - lightCone.y, 1e-4), 0.0, 1.0);
        factor *= ramp * ramp;
    }
    if (LIGHT_IS(LIGHT_RECT)) factor *= lightCone.w * max(alongAxis, 0.0);
    return lightColor.rgb * factor;
}
