// SPDX-License-Identifier: MIT
// NORMALS: 0 interpolated, 1 bump-mapped (height maps), 2 tangent-space normal maps (height maps where there is none).
#include "ombrage/frame.glsl"
#include "ombrage/octahedral.glsl"
#include "ombrage/alpha.glsl"

layout(std430, binding = TRIANGLE_NORMAL_STORAGE) readonly buffer TriangleNormals { uint b_triangleNormals[]; };
layout(binding = UNIT_NORMAL_MAP) uniform sampler2D t_normalMap;
layout(binding = UNIT_HEIGHT) uniform sampler2D t_height;
layout(binding = UNIT_METALLIC_ROUGHNESS) uniform sampler2D t_metallicRoughness;

in vec3 v_position;
in vec3 v_normal;
in vec4 v_tangent;
in vec2 v_uv;
flat in uint v_instance;
#ifdef VERTEX_COLORS
in vec3 v_color;
#endif

layout(location = 0) out vec4 o_normals;
layout(location = 1) out vec4 o_albedo;
layout(location = 2) out vec4 o_material;
layout(location = 3) out uvec2 o_ids;

// Blinn 1978: N' = N + (h_u (N x P_v) - h_v (N x P_u)) / |N|, with P_u, P_v of the unit tangent frame and forward differences of
// one texel; heights are in units of uv, so both differences are slopes. b points to smaller v: P_v = -b.
vec3 bumpNormal(vec3 n, vec3 t, vec3 b, float heightScale_uv) {
    vec2 texel = 1.0 / vec2(textureSize(t_height, 0));
    float h = texture(t_height, v_uv).r;
    float slopeU = (texture(t_height, v_uv + vec2(texel.x, 0.0)).r - h) * heightScale_uv / texel.x;
    float slopeV = (texture(t_height, v_uv + vec2(0.0, texel.y)).r - h) * heightScale_uv / texel.y;
    return normalize(n - slopeU * t + slopeV * b);
}

void main() {
    InstanceData instance = b_instances[v_instance];
    MaterialData m = b_materials[instance.material];
#ifdef ALPHA_MASK
    if (isHole(instance.material, v_uv)) discard;
#endif

    // n_g from the triangle itself, turned to the side that the eye sees.
    vec3 n_local = unitFromOctahedral(unpackSnorm2x16(b_triangleNormals[instance.firstMeshTriangle + uint(gl_PrimitiveID)]));
    vec3 n_g = normalize(mat3(instance.normalFromLocal) * n_local);
    vec3 toEye = isOrthographic() ? -frame.forward.xyz : frame.eye.xyz - v_position;
    if (dot(n_g, toEye) < 0.0) n_g = -n_g;
    vec3 n_s = normalize(v_normal);
    bool turned = dot(n_s, n_g) < 0.0;

#if NORMALS > 0
    // A frame about the front's normal; degenerate tangents leave the normal alone.
    vec3 t = v_tangent.xyz - n_s * dot(n_s, v_tangent.xyz);
    if (dot(t, t) > 1e-12) {
        t = normalize(t);
        vec3 b = cross(n_s, t) * (v_tangent.w < 0.0 ? -1.0 : 1.0);
#if NORMALS == 2
        if ((m.textures.x & 2u) != 0u) {
            vec3 mapped = texture(t_normalMap, v_uv).xyz * 2.0 - 1.0;
            mapped.xy *= m.surface.z;
            n_s = normalize(mapped.x * t + mapped.y * b + mapped.z * n_s);
        } else
#endif
        if ((m.textures.x & 4u) != 0u) {
            n_s = bumpNormal(n_s, t, b, m.surface.w);
        }
    }
#endif
    // The back has the reversed normal, as glTF 2 asks: what is a bump in front is a dent behind.
    if (turned) n_s = -n_s;

    vec4 base = m.baseColor;
#ifdef VERTEX_COLORS
    base.rgb *= v_color;
#endif
    if ((m.textures.x & 1u) != 0u) base *= texture(t_baseColor, v_uv);
    float metallic = m.surface.x, roughness = m.surface.y;
    if ((m.textures.x & 8u) != 0u) {
        vec4 texel = texture(t_metallicRoughness, v_uv);
        metallic *= texel.b;
        roughness *= texel.g;
    }

    o_normals = vec4(octahedralFromUnit(n_g), octahedralFromUnit(n_s)) * 0.5 + 0.5;
    o_albedo = vec4(base.rgb, 1.0);
    o_material = vec4(metallic, roughness, dot(m.specular.rgb, vec3(0.2126, 0.7152, 0.0722)), min(m.specular.a, 255.0) / 255.0);
    o_ids = uvec2(v_instance, instance.firstTriangle + uint(gl_PrimitiveID));
}
