// SPDX-License-Identifier: MIT
// Composes one light, and with FIRST_LIGHT also the ambient and emitted light and the sky.
// SHADING: 0 Phong, 1 Blinn-Phong, 2 metallic-roughness. AMBIENT: 0 constant, 1 times occlusion, 2 off.
#include "ombrage/frame.glsl"
#include "ombrage/gbuffer.glsl"
#include "ombrage/instances.glsl"
#include "ombrage/light.glsl"

layout(binding = 5) uniform sampler2D t_visibility;
layout(binding = 6) uniform sampler2D t_ao;
layout(binding = 7) uniform sampler2D t_indirect;

uniform float u_ambient;
uniform int u_hasLight;       // 0: the scene has no light to add
uniform int u_useVisibility;  // 0: unshadowed, for the naive ways of composing

in vec2 v_uv;
layout(location = 0) out vec4 o_color;

const float kPi = 3.14159265358979;

// Microfacet reflection (Walter et al. 2007 GGX, Smith-Schlick masking, Schlick Fresnel), as glTF 2 defines it.
vec3 metallicRoughness(vec3 albedo, float metallic, float roughness, float nl, float nv, float nh, float vh) {
    float alpha = max(roughness * roughness, 1e-3);
    float a2 = alpha * alpha;
    float d = nh * nh * (a2 - 1.0) + 1.0;
    float distribution = a2 / (kPi * d * d);
    float visibilityTerm = 0.5 / (nl * sqrt(nv * nv * (1.0 - a2) + a2) + nv * sqrt(nl * nl * (1.0 - a2) + a2) + 1e-6);
    vec3 f0 = mix(vec3(0.04), albedo, metallic);
    vec3 fresnel = f0 + (1.0 - f0) * pow(1.0 - vh, 5.0);
    return (1.0 - fresnel) * (1.0 - metallic) * albedo / kPi + fresnel * distribution * visibilityTerm;
}

void main() {
    ivec2 px = ivec2(gl_FragCoord.xy);
    float depth = gbufferDepth(px);
    if (depth == 0.0) {
#ifdef FIRST_LIGHT
        // The surroundings' own radiance, as in the truth's picture.
        o_color = vec4(vec3(u_ambient), 1.0);
        return;
#else
        discard;
#endif
    }
    vec3 p_world = positionWorldFromDepth(v_uv, depth);
    vec3 n_g = gbufferGeometricNormal(px);
    vec3 n_s = gbufferShadingNormal(px);
    vec3 albedo = texelFetch(t_albedo, px, 0).rgb;
    vec4 surface = texelFetch(t_material, px, 0);

    vec3 color = vec3(0.0);
    uint instance = gbufferIds(px).x;
#ifdef FIRST_LIGHT
    color = b_materials[b_instances[instance].material].emissive.rgb;
#if AMBIENT == 0
    color += albedo * u_ambient;
#elif AMBIENT == 1
    color += albedo * u_ambient * texelFetch(t_ao, px, 0).r;
#endif
    color += texelFetch(t_indirect, px, 0).rgb;
#endif

    float distance_m;
    vec3 l = directionToLight(p_world, distance_m);
    float nl = dot(n_s, l);
    // The geometric horizon shadows whatever the shading normal says, in the truth and here alike.
    if (u_hasLight != 0 && nl > 0.0 && dot(n_g, l) > 0.0 && !lightExcludes(instance)) {
        bool receives = (b_instances[instance].flags & 2u) == 0u;
        float seen = u_useVisibility != 0 && receives ? texelFetch(t_visibility, px, 0).r : 1.0;
        vec3 irradiance = irradianceFacing(l, distance_m) * nl * seen;
        vec3 v = directionToEye(p_world);
        vec3 h = normalize(l + v);
        float shininess = surface.w * 255.0;
#if SHADING == 0
        // Phong 1975, normalised so that the lobe's energy does not grow with the exponent.
        float lobe = pow(max(dot(reflect(-l, n_s), v), 0.0), shininess) * (shininess + 2.0) / (2.0 * kPi);
        color += irradiance * (albedo / kPi + surface.z * lobe);
#elif SHADING == 1
        // Blinn 1977 with 4 times Phong's exponent, normalised likewise.
        float exponent = 4.0 * shininess;
        float lobe = pow(max(dot(n_s, h), 0.0), exponent) * (exponent + 8.0) / (8.0 * kPi);
        color += irradiance * (albedo / kPi + surface.z * lobe);
#else
        color += irradiance * metallicRoughness(albedo, surface.x, surface.y, nl, max(dot(n_s, v), 1e-4), max(dot(n_s, h), 0.0),
                                                max(dot(v, h), 0.0));
#endif
    }
    o_color = vec4(color, 1.0);
}
