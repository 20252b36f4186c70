// SPDX-License-Identifier: MIT
// Composes one light (LIGHT_TYPE; none without it) over the surfaces; the sky stays as it is.
// FIRST_LIGHT's pass adds what no light owns: EMISSION of some material, AMBIENT light, dimmed by OCCLUSION, and INDIRECT light.
// VISIBILITY: the light is shadowed by an image (COLORED: of three colours), LOOKUP: by what stands behind "ombrage/shadow_lookup". EXCEPTIONS: some instances exclude a light or receive no shadow.
// PIXEL_SAMPLES: over the pixels that show several surfaces (ombrage/edge_samples.glsl), each of their samples into a target of its own.
// MATERIAL_PLANE: the surfaces reflect more than diffusely, by SHADING: 0 Phong, 1 Blinn-Phong, 2 metallic-roughness.
#include "ombrage/frame.glsl"
#ifdef PIXEL_SAMPLES
#include "ombrage/edge_samples.glsl"
#else
#include "ombrage/gbuffer.glsl"
#endif
#include "ombrage/instances.glsl"
#include "ombrage/light.glsl"
#include "ombrage/shadow_lookup"

#ifdef VISIBILITY
layout(binding = 5) uniform sampler2D t_visibility;
#endif
layout(binding = 3) uniform sampler2D t_ao;
layout(binding = 4) uniform sampler2D t_indirect;

noperspective in vec2 v_uv;
noperspective in vec3 v_rayStart;
noperspective in vec3 v_rayAlong;
#ifdef PIXEL_SAMPLES
layout(location = 0) out vec4 o_samples[PIXEL_SAMPLES];
#define MATERIAL_OF(px, s) unpackUnorm4x8(sampleMaterial(px, s))
#else
#define MATERIAL_OF(px, s) gbufferMaterial(px)
layout(location = 0) out vec4 o_color;
#endif

const float kPi = 3.14159265358979;

// Microfacet reflection (Walter et al. 2007 GGX, Smith-Schlick masking, Schlick Fresnel), as glTF 2 defines it.
vec3 metallicRoughness(vec3 albedo, float metallic, float roughness, float nl, float nv, float nh, float vh) {
    float alpha = max(roughness * roughness, 1e-3);
    float a2 = alpha * alpha;
    float d = nh * nh * (a2 - 1.0) + 1.0;
    float distribution = a2 / (kPi * d * d);
    float visibilityTerm = 0.5 / (nl * sqrt(nv * nv * (1.0 - a2) + a2) + nv * sqrt(nl * nl * (1.0 - a2) + a2) + 1e-6);
    vec3 f0 = mix(vec3(0.04), albedo, metallic);
    vec3 fresnel = f0 + (1.0 - f0) * pow(max(1.0 - vh, 0.0), 5.0);
    return (1.0 - fresnel) * (1.0 - metallic) * albedo / kPi + fresnel * distribution * visibilityTerm;
}

// What a surface shows of the light, and of what no light owns. It is that of the pixel `own`, of its sample s; visibility, occlusion
// and indirect light are read at `px`.
vec3 shaded(uvec4 surface, vec3 p_world, ivec2 own, int s, ivec2 px) {
    vec3 albedo = unpackedAlbedo(surface.z);
    vec3 color = vec3(0.0);
#if defined(EMISSION) || defined(EXCEPTIONS)
    uint instance = b_triangles[surface.w];
#endif
#ifdef EMISSION
    color += b_materials[b_instances[instance].material].emissive.rgb;
#endif
#ifdef AMBIENT
    float open = frameForward.w;
#ifdef OCCLUSION
    open *= texelFetch(t_ao, px, 0).r;
#endif
    color += albedo * open;
#endif
#ifdef INDIRECT
    color += texelFetch(t_indirect, px, 0).rgb;
#endif

#ifdef LIGHT_TYPE
    float distance_m;
    vec3 l = directionToLight(p_world, distance_m);
    vec3 n_s = shadingNormalOf(surface);
    float nl = dot(n_s, l);
    // The geometric horizon shadows whatever the shading normal says, in the truth and here alike.
    vec3 n_g = geometricDirectionOf(surface);
    bool lit = nl > 0.0 && dot(n_g, l) > 0.0;
#if defined(VISIBILITY) && defined(COLORED)
    vec3 seen = texelFetch(t_visibility, px, 0).rgb;
    const vec3 allSeen = vec3(1.0);
#else
    float seen = 1.0;
    const float allSeen = 1.0;
#endif
#if defined(VISIBILITY) && !defined(COLORED)
    seen = texelFetch(t_visibility, px, 0).r;
#elif defined(LOOKUP)
    seen = shadowVisibility(p_world, n_g);
#endif
#ifdef EXCEPTIONS
    if (lightExcludes(instance)) lit = false;
    if ((b_instances[instance].flags & INSTANCE_UNSHADOWED) != 0u) seen = allSeen;
#endif
    if (lit) {
        vec3 irradiance = irradianceFacing(l, distance_m) * (nl * seen);
        vec3 diffuse = albedo * (1.0 / kPi);
#ifdef MATERIAL_PLANE
        vec4 material = MATERIAL_OF(own, s);
        vec3 v = directionToEye(p_world);
        vec3 h = normalize(l + v);
        float shininess = material.w * 255.0;
#if SHADING == 0
        // Phong 1975, normalised so that the lobe's energy does not grow with the exponent.
        float lobe = pow(max(dot(reflect(-l, n_s), v), 0.0), shininess) * (shininess + 2.0) / (2.0 * kPi);
        color += irradiance * (diffuse + material.z * lobe);
#elif SHADING == 1
        // Blinn 1977 with 4 times Phong's exponent, normalised likewise.
        float exponent = 4.0 * shininess;
        float lobe = pow(max(dot(n_s, h), 0.0), exponent) * (exponent + 8.0) / (8.0 * kPi);
        color += irradiance * (diffuse + material.z * lobe);
#else
        color += irradiance * metallicRoughness(albedo, material.x, material.y, nl, max(dot(n_s, v), 1e-4), max(dot(n_s, h), 0.0),
                                                max(dot(v, h), 0.0));
#endif
#else
        color += irradiance * diffuse;
#endif
    }
#endif
    return color;
}

#ifdef PIXEL_SAMPLES
void main() {
    ivec2 px = ivec2(v_uv * frameViewport.xy);
    uint bits = edgeBits(px);
    if (bits == 0u) discard;
    uint triangles[PIXEL_SAMPLES];
    vec3 colors[PIXEL_SAMPLES];
    for (int s = 0; s < PIXEL_SAMPLES; ++s) {
        float depth = sampleDepth(px, s);
        uvec4 surface = sampleSurface(px, s);
        triangles[s] = depth > 0.0 ? surface.w : kSky;
        // Samples of one triangle have one surface: it is lit once.
        int first = 0;
        while (triangles[first] != triangles[s]) ++first;
        if (first < s) {
            colors[s] = colors[first];
        } else if (depth == 0.0) {
#ifdef FIRST_LIGHT
            colors[s] = vec3(frameForward.w);
#else
            colors[s] = vec3(0.0);
#endif
        } else {
            vec3 p_world = positionOn(rayBeside(v_rayStart, v_rayAlong, kSamplePositions[s]), depth);
            colors[s] = shaded(surface, p_world, px, s, pixelOfSample(px, bits, s));
        }
        o_samples[s] = vec4(colors[s], 1.0);
    }
}
#else
void main() {
    ivec2 px = ivec2(v_uv * frameViewport.xy);
#ifdef LIGHT_TYPE
    vec3 p_world = positionOnRay(v_rayStart, v_rayAlong, gbufferDepthAt(v_uv));
#else
    vec3 p_world = vec3(0.0);
#endif
    o_color = vec4(shaded(gbufferSurfaceAt(v_uv), p_world, px, 0, px), 1.0);
}
#endif
