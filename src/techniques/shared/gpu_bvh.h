// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "gl/objects.h"
#include "gl/shader_library.h"
#include "render/gpu_scene.h"

namespace ombrage {

/// The scene's triangles and a hierarchy over those that cast, in storage buffers for shared/gpu_bvh.glsl. Shared
/// through GpuScene::derived().
class GpuBvh {
public:
    /// @throws Error(Environment) when a buffer is larger than the driver's storage blocks.
    explicit GpuBvh(const GpuScene& scene);

    /// Binds the storage buffers 3 to 6 and sets the program's uniforms.
    void bind(const gl::Program& program) const;

    std::uint64_t gpuBytes() const;

private:
    void packTriangles(const GpuScene& scene, const std::vector<std::uint32_t>& order);

    std::uint32_t m_nodeCount = 0;
    float m_extent_m = 0;
    gl::Buffer m_nodes, m_triangles, m_slots, m_alpha;
};

/// The per-instance flags of shared/gpu_bvh.glsl with EXCLUDES: 1 where the model is in the list.
gl::Buffer excludedInstances(const GpuScene& scene, const std::vector<int>& excludedModels);
/// The per-instance models of shared/gpu_bvh.glsl with SAME_MODEL.
gl::Buffer instanceModels(const GpuScene& scene);
/// Where either is bound.
inline constexpr unsigned kExcludedStorage = 7;

}  // namespace ombrage
