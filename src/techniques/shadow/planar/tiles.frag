// SPDX-License-Identifier: MIT
// Per tile of the mask: x the greatest height of a caster, less than 0 where there is none; y 1 where casters cover all of it.
layout(binding = 5) uniform sampler2D t_mask;

uniform int u_tile_px;
uniform float u_tallest_m;   // height of which the mask holds shares

layout(location = 0) out vec2 o_tile;

void main() {
    ivec2 size = textureSize(t_mask, 0), first = ivec2(gl_FragCoord.xy) * u_tile_px;
    ivec2 last = min(first + u_tile_px, size);
    o_tile = vec2(-1.0, 1.0);
    for (int y = first.y; y < last.y; ++y)
        for (int x = first.x; x < last.x; ++x) {
            vec2 texel = texelFetch(t_mask, ivec2(x, y), 0).xy;
            if (texel.x > 0.0) o_tile.x = max(o_tile.x, (1.0 - texel.y) * u_tallest_m);
            else o_tile.y = 0.0;
        }
}
