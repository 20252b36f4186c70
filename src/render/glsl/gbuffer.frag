// SPDX-License-Identifier: MIT
// One variant per kind of material: BASE_COLOR_MAP, NORMAL_MAP (tangent space), HEIGHT_MAP (bump), METALLIC_ROUGHNESS_MAP,
// ALPHA_MASK, UV for any of them; VERTEX_COLORS where the scene has any; MATERIAL_PLANE where lighting needs the material;
// FRONT_ONLY where back faces are culled. PIXEL_SAMPLES of a pixel, where it has several: what is interpolated is then that of a point inside of
// the triangle; ALPHA_SAMPLES: the alpha test is made at each.
#include "ombrage/frame.glsl"
#include "ombrage/octahedral.glsl"
#include "ombrage/surface.glsl"
#include "ombrage/alpha.glsl"

layout(binding = UNIT_NORMAL_MAP) uniform sampler2D t_normalMap;
layout(binding = UNIT_HEIGHT) uniform sampler2D t_height;
layout(binding = UNIT_METALLIC_ROUGHNESS) uniform sampler2D t_metallicRoughness;

#ifdef PIXEL_SAMPLES
#define INSIDE centroid
#else
#define INSIDE
#endif
#if defined(NORMAL_MAP) || defined(HEIGHT_MAP)
INSIDE in vec4 v_tangent;
#endif
#ifdef UV
INSIDE in vec2 v_uv;
#endif
#ifdef VERTEX_COLORS
INSIDE in vec3 v_color;
#endif
INSIDE in vec3 v_normal;
flat in uvec4 v_surface;
#ifdef MATERIAL_PLANE
flat in uint v_material;
#endif

layout(location = 0) out uvec4 o_surface;
#ifdef MATERIAL_PLANE
layout(location = 1) out uint o_material;
#endif

#ifdef HEIGHT_MAP
// Blinn 1978: N' = N + (h_u (N x P_v) - h_v (N x P_u)) / |N|, with P_u, P_v of the unit tangent frame and forward differences of
// one texel; heights are in units of uv, so both differences are slopes. b points to smaller v: P_v = -b.
vec3 bumpNormal(vec3 n, vec3 t, vec3 b, float heightScale_uv, vec2 uv) {
    vec2 texel = 1.0 / vec2(textureSize(t_height, 0));
    float h = texture(t_height, uv).r;
    float slopeU = (texture(t_height, uv + vec2(texel.x, 0.0)).r - h) * heightScale_uv / texel.x;
    float slopeV = (texture(t_height, uv + vec2(0.0, texel.y)).r - h) * heightScale_uv / texel.y;
    return normalize(n - slopeU * t + slopeV * b);
}
#endif

#if defined(NORMAL_MAP) || defined(HEIGHT_MAP)
vec3 perturbed(vec3 n_s, MaterialData m, vec2 uv) {
    // A frame about the front's normal; degenerate tangents leave the normal alone.
    n_s = normalize(n_s);
    vec3 t = v_tangent.xyz - n_s * dot(n_s, v_tangent.xyz);
    if (dot(t, t) <= 1e-12) return n_s;
    t = normalize(t);
    vec3 b = cross(n_s, t) * (v_tangent.w < 0.0 ? -1.0 : 1.0);
#ifdef NORMAL_MAP
    vec3 mapped = texture(t_normalMap, uv).xyz * 2.0 - 1.0;
    mapped.xy *= m.surface.z;
    return normalize(mapped.x * t + mapped.y * b + mapped.z * n_s);
#else
    return bumpNormal(n_s, t, b, m.surface.w, uv);
#endif
}
#endif

void main() {
#ifdef UV
    vec2 uv = v_uv;   // what the textures are read at
#endif
#ifdef ALPHA_SAMPLES
    // Coverage is what the texture leaves at each sample; the surface is read in the middle of it.
    int covered = 0, count = 0;
    vec2 middle = vec2(0.0);
    for (int s = 0; s < PIXEL_SAMPLES; ++s) {
        vec2 at = interpolateAtSample(v_uv, s);
        if (isHole(v_surface.w, at)) continue;
        covered |= 1 << s;
        ++count;
        middle += at;
    }
    if (count == 0) discard;
    gl_SampleMask[0] = covered;
    uv = middle / float(count);
#elif defined(ALPHA_MASK)
    if (isHole(v_surface.w, uv)) discard;
#endif
    // n_g of the triangle itself, turned to the side that the eye sees.
    uint facet = v_surface.y;
    vec2 o_g = octahedralFromWord(facet);
#ifndef FRONT_ONLY
    if (!gl_FrontFacing) {
        o_g = octahedralOpposite(o_g);
        facet = packSnorm2x16(o_g);
    }
#endif

    // The back has the reversed normal, as glTF 2 asks: what is a bump in front is a dent behind.
    vec3 n_s = v_normal;
    bool turned = dot(n_s, vectorFromOctahedral(o_g)) < 0.0;
#if defined(NORMAL_MAP) || defined(HEIGHT_MAP)
    n_s = perturbed(n_s, b_materials[v_surface.w], uv);
#endif
    if (turned) n_s = -n_s;

    uint albedo = v_surface.x;
#if defined(BASE_COLOR_MAP) || defined(VERTEX_COLORS)
    vec3 base = b_materials[v_surface.w].baseColor.rgb;
#ifdef BASE_COLOR_MAP
    base *= texture(t_baseColor, uv).rgb;
#endif
#ifdef VERTEX_COLORS
    base *= v_color;
#endif
    albedo = packedAlbedo(base);
#endif
    o_surface = uvec4(facet, packSnorm2x16(octahedralFromVector(n_s)), albedo, v_surface.z);

#ifdef MATERIAL_PLANE
    o_material = v_material;
#ifdef METALLIC_ROUGHNESS_MAP
    vec4 texel = texture(t_metallicRoughness, uv);
    o_material = packUnorm4x8(unpackUnorm4x8(v_material) * vec4(texel.b, texel.g, 1.0, 1.0));
#endif
#endif
}
