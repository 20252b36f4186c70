// SPDX-License-Identifier: MIT
// Reads the G-buffer in a full-screen pass or a compute shader. Pixels count from the lower left. What comes out for the
// sky, where only depth is written, means nothing.
#include "ombrage/bindings.glsl"
#include "ombrage/octahedral.glsl"
#include "ombrage/surface.glsl"

layout(binding = UNIT_DEPTH) uniform sampler2D t_depth;
layout(binding = UNIT_SURFACE) uniform usampler2D t_surface;
layout(binding = UNIT_MATERIAL) uniform usampler2D t_material;

// Reversed-Z depth; 0 is the sky.
float gbufferDepth(ivec2 px) { return texelFetch(t_depth, px, 0).r; }

// A whole texel, for passes that want several of what follows.
uvec4 gbufferSurface(ivec2 px) { return texelFetch(t_surface, px, 0); }

// Both of the pixel around a point of the picture, [0,1]: less work than texelFetch() for drivers to which a level of detail, even
// of 0, is one per pixel (llvmpipe: 70 instructions in the place of 170).
float gbufferDepthAt(vec2 uv) { return texture(t_depth, uv).r; }
uvec4 gbufferSurfaceAt(vec2 uv) { return texture(t_surface, uv); }

// n_g of a texel: normal of the triangle, towards the eye; as it is stored, of any length, and unit.
vec3 geometricDirectionOf(uvec4 surface) { return vectorFromOctahedral(octahedralFromWord(surface.x)); }
vec3 geometricNormalOf(uvec4 surface) { return normalize(geometricDirectionOf(surface)); }

// n_s of a texel: interpolated and perturbed normal, on the side of n_g before perturbation.
vec3 shadingNormalOf(uvec4 surface) { return unitFromOctahedral(octahedralFromWord(surface.y)); }

vec3 gbufferGeometricNormal(ivec2 px) { return geometricNormalOf(gbufferSurface(px)); }
vec3 gbufferShadingNormal(ivec2 px) { return shadingNormalOf(gbufferSurface(px)); }

// Global triangle.
uint gbufferTriangle(ivec2 px) { return gbufferSurface(px).w; }

// Metallic, roughness, specular luminance, shininess / 255: only where lighting asked for it (MATERIAL_PLANE).
vec4 gbufferMaterial(ivec2 px) { return unpackUnorm4x8(texelFetch(t_material, px, 0).r); }
