// SPDX-License-Identifier: MIT
// Counts the depths of a light's map in BINS equal bins of z.
#include "shared/moment_range.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(std430, binding = 11) buffer Counts { uint b_counts[]; };

#if LIGHT_VIEWS == 1
layout(binding = 5) uniform sampler2D t_depth;
#else
layout(binding = 5) uniform sampler2DArray t_depth;
#endif

shared uint s_counts[BINS];

void main() {
    for (uint i = gl_LocalInvocationIndex; i < BINS; i += 256u) s_counts[i] = 0u;
    barrier();

    // Each thread takes four by four texels, a block's side apart. Where nothing casts nothing counts.
    ivec2 size = textureSize(t_depth, 0).xy;
    for (int i = 0; i < 16; ++i) {
        ivec2 texel = ivec2(gl_WorkGroupID.xy) * 64 + ivec2(gl_LocalInvocationID.xy) + 16 * ivec2(i % 4, i / 4);
        if (any(greaterThanEqual(texel, size))) continue;
#if LIGHT_VIEWS == 1
        float depth = texelFetch(t_depth, texel, 0).r;
#else
        float depth = texelFetch(t_depth, ivec3(texel, int(gl_WorkGroupID.z)), 0).r;
#endif
        if (!(depth > 0.0)) continue;
        float z = momentDepth(lightViewDistance(int(gl_WorkGroupID.z), min(depth, 1.0)));
        atomicAdd(s_counts[clamp(int((z * 0.5 + 0.5) * float(BINS)), 0, BINS - 1)], 1u);
    }
    barrier();
    for (uint i = gl_LocalInvocationIndex; i < BINS; i += 256u)
        if (s_counts[i] > 0u) atomicAdd(b_counts[i], s_counts[i]);
}
