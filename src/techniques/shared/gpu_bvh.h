// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "techniques/shared/gpu_triangles.h"

namespace ombrage {

/// The scene's triangles and a hierarchy over those that cast, in storage buffers for shared/gpu_bvh.glsl. Shared
/// through GpuScene::derived().
class GpuBvh {
public:
    /// @throws Error(Environment) when a buffer is larger than the driver's storage blocks.
    explicit GpuBvh(const GpuScene& scene) : GpuBvh(scene, castingTriangles(scene)) {}
    /// The same over other triangles. @param triangles global ids
    GpuBvh(const GpuScene& scene, const std::vector<std::uint32_t>& triangles);

    /// Binds the storage buffers 3 to 6 and sets the program's uniforms.
    void bind(const gl::Program& program) const;

    std::uint64_t gpuBytes() const;

private:
    std::uint32_t m_nodeCount = 0;
    gl::Buffer m_nodes;
    GpuTriangles m_triangles;
};

}  // namespace ombrage
