// SPDX-License-Identifier: MIT
// Reads the G-buffer in a full-screen pass or a compute shader. Pixels count from the lower left.
#include "ombrage/bindings.glsl"
#include "ombrage/octahedral.glsl"

layout(binding = UNIT_DEPTH) uniform sampler2D t_depth;
layout(binding = UNIT_NORMALS) uniform sampler2D t_normals;
layout(binding = UNIT_ALBEDO) uniform sampler2D t_albedo;
layout(binding = UNIT_MATERIAL) uniform sampler2D t_material;
layout(binding = UNIT_IDS) uniform usampler2D t_ids;

// Reversed-Z depth; 0 is the sky.
float gbufferDepth(ivec2 px) { return texelFetch(t_depth, px, 0).r; }

// n_g: unit normal of the triangle, towards the eye.
vec3 gbufferGeometricNormal(ivec2 px) { return unitFromOctahedral(texelFetch(t_normals, px, 0).xy * 2.0 - 1.0); }

// n_s: interpolated and perturbed normal, on the side of n_g before perturbation.
vec3 gbufferShadingNormal(ivec2 px) { return unitFromOctahedral(texelFetch(t_normals, px, 0).zw * 2.0 - 1.0); }

// Instance and global triangle.
uvec2 gbufferIds(ivec2 px) { return texelFetch(t_ids, px, 0).rg; }
