// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "gl/objects.h"
#include "render/gpu_scene.h"

namespace ombrage {

/// Topology of every mesh for the shaders that find silhouettes (shared/volume_edges.glsl). Shared through
/// GpuScene::derived().
struct GpuTopology {
    explicit GpuTopology(const GpuScene& scene);

    struct Range {
        std::uint32_t firstPair = 0, pairs = 0, firstTriangle = 0, triangles = 0;
    };
    std::vector<Range> meshes;
    gl::Buffer pairs;          ///< uvec4: two vertices of the mesh, two uses (EdgePair)
    gl::Buffer planes;         ///< vec4 per triangle, in the mesh's space
    gl::Buffer pairIndices;    ///< uint: two vertices of the scene per pair
    gl::Buffer triangles;      ///< uint: three vertices of the scene per triangle
    gl::Buffer corners;        ///< vec3: their positions, in the mesh's space
    gl::Buffer cornerIndices;  ///< uint: 0, 1, 2 ...
};

/// What the shaders know of each instance's volume; the layout of Caster in shared/volume_edges.glsl.
struct alignas(16) GpuCaster {
    glm::vec4 light_local{0.0f};
    std::uint32_t firstPair = 0, pairs = 0, firstTriangle = 0, triangles = 0;
    std::uint32_t firstVertex = 0;
    float inPlane_local = 0;  ///< as VolumeRequest has it
    std::uint32_t flags = 0;  ///< kCaster...
};
inline constexpr std::uint32_t kCasterBoth = 1, kCasterMirrored = 2, kCasterFarEnds = 4;

/// Storage buffer bindings of shared/volume_edges.glsl and shared/volume_ends.glsl.
inline constexpr unsigned kCasterStorage = 3, kPairStorage = 4, kPlaneStorage = 5, kTriangleVertexStorage = 6,
                          kVolumeCommandStorage = 8, kVolumeIndexStorage = 9, kSlabStorage = 10;

}  // namespace ombrage
