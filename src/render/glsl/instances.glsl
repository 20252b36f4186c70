// SPDX-License-Identifier: MIT
// Instances and materials of the scene (render/gpu_scene.cpp packs them).
#include "ombrage/bindings.glsl"

struct InstanceData {
    mat4 worldFromLocal;
    mat4 normalFromLocal;   // inverse transpose, upper 3x3
    uint material;
    uint firstTriangle;     // global id of the instance's first triangle
    uint firstMeshTriangle; // of its mesh, into b_triangleNormals
    uint flags;             // 1: mirrored, 2: receives no shadow
};

struct MaterialData {
    vec4 baseColor;         // a: opacity
    vec4 specular;          // rgb, a: shininess
    vec4 emissive;          // rgb, a: alpha cut-off
    vec4 surface;           // metallic, roughness, normal scale, height scale in uv
    uvec4 textures;         // bits of x: 1 base colour, 2 normal map, 4 height map, 8 metallic-roughness, 16 emissive; y: 1 alpha mask
};

layout(std430, binding = INSTANCE_STORAGE) readonly buffer Instances { InstanceData b_instances[]; };
layout(std430, binding = MATERIAL_STORAGE) readonly buffer Materials { MaterialData b_materials[]; };
