// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "gl/objects.h"
#include "gl/shader_library.h"
#include "render/gpu_scene.h"

namespace ombrage {

/// The scene's triangles in storage buffers for shared/ray_triangles.glsl.
class GpuTriangles {
public:
    GpuTriangles() = default;
    /// @param order global ids of the triangles that take the first places; the others follow.
    /// @throws Error(Environment) when a buffer is larger than the driver's storage blocks.
    GpuTriangles(const GpuScene& scene, std::vector<std::uint32_t> order);

    /// Binds the storage buffers 4 to 6 and sets the program's uniforms.
    void bind(const gl::Program& program) const;

    std::uint64_t gpuBytes() const { return m_triangles.size() + m_slots.size() + m_alpha.size(); }

private:
    float m_extent_m = 0;
    gl::Buffer m_triangles, m_slots, m_alpha;
};

/// Global ids of the triangles whose instances cast.
std::vector<std::uint32_t> castingTriangles(const GpuScene& scene);
/// Of all.
std::vector<std::uint32_t> allTriangles(const GpuScene& scene);

/// @throws Error(Environment) when the driver's storage blocks do not hold that many bytes.
void checkStorageSize(std::size_t bytes);

/// The per-instance flags of shared/ray_triangles.glsl with EXCLUDES: 1 where the model is in the list.
gl::Buffer excludedInstances(const GpuScene& scene, const std::vector<int>& excludedModels);
/// The per-instance models of shared/ray_triangles.glsl with SAME_MODEL.
gl::Buffer instanceModels(const GpuScene& scene);
/// Where either is bound.
inline constexpr unsigned kExcludedStorage = 7;

}  // namespace ombrage
