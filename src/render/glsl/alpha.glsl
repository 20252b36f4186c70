// SPDX-License-Identifier: MIT
// Holes of alpha-tested surfaces: nearest texel of level 0, repeated, the same rule as the ray-traced truth's.
#include "ombrage/instances.glsl"

layout(binding = UNIT_BASE_COLOR) uniform sampler2D t_baseColor;

bool isHole(uint material, vec2 uv) {
    MaterialData m = b_materials[material];
    if (m.textures.y == 0u) return false;
    float alpha = m.baseColor.a;
    if ((m.textures.x & 1u) != 0u) {
        ivec2 size = textureSize(t_baseColor, 0);
        ivec2 texel = min(ivec2(fract(uv) * vec2(size)), size - 1);
        alpha *= texelFetch(t_baseColor, texel, 0).a;
    }
    return alpha < m.emissive.a;
}
