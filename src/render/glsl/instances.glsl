// SPDX-License-Identifier: MIT
// Instances, materials and triangles of the scene (render/gpu_scene.cpp packs them).
#include "ombrage/bindings.glsl"

#define INSTANCE_MIRRORED 1u
#define INSTANCE_UNSHADOWED 2u   // receives no shadow

struct InstanceData {
    mat4 worldFromLocal;
    uint baseColor;         // of its material, packed as in the G-buffer
    uint surface;           // likewise
    uint firstTriangle;     // global id of the instance's first triangle
    uint material;
    uint flags;             // INSTANCE_...
    uint index;             // its own
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

// The instance of each global triangle.
layout(std430, binding = TRIANGLE_STORAGE) readonly buffer Triangles { uint b_triangles[]; };
