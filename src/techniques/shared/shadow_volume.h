// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "gl/objects.h"
#include "gl/shader_library.h"
#include "render/gpu_scene.h"
#include "techniques/shared/silhouette.h"

namespace ombrage {

class FrameContext;
struct LightFrame;

/// Adjacency of every mesh of a scene and the bounds of its instances; shared through GpuScene::derived().
class SceneTopology {
public:
    explicit SceneTopology(const GpuScene& scene);

    const MeshTopology& mesh(int index) const { return m_meshes[std::size_t(index)]; }
    /// In the space moved by the origin, of the instance's vertices.
    glm::vec3 lower(std::size_t instance) const { return m_lower[instance]; }
    glm::vec3 upper(std::size_t instance) const { return m_upper[instance]; }

private:
    std::vector<MeshTopology> m_meshes;
    std::vector<glm::vec3> m_lower, m_upper;
};

/// Both ends of every vertex, the corner itself (w 1) and the same to be sent to infinity (w 0), one after the other, so that
/// the codes of VolumeTriangles are indices. Shared through GpuScene::derived().
struct VolumeVertices {
    explicit VolumeVertices(const GpuScene& scene);
    gl::Buffer buffer;   ///< vec4, local
};

struct ShadowVolumeOptions {
    bool perTriangle = false;  ///< a volume per casting triangle instead of one per silhouette
    bool caps = true;          ///< as depth-fail counting needs
    bool operator==(const ShadowVolumeOptions&) const = default;
};

/// Shadow volumes of all casters of one light, extruded to infinity. The CPU finds which triangles bound them and emits
/// indices only; positions come from the G-buffer's own vertices through ombrage/vertex.glsl, so both meet bit by bit.
class ShadowVolumes {
public:
    /// Builds them anew when the light, the options or the side that the eye is on changed.
    void update(FrameContext& frame, const LightFrame& light, const ShadowVolumeOptions& options);

    /// Forgets everything; call when the scene changed.
    void reset();

    /// Draws with the program of shared/shadow_volume.vert in use. `outward` triangles are counter-clockwise seen from
    /// outside the volume, the others clockwise: swap what the two sides do.
    void draw(FrameContext& frame, const LightFrame& light, const gl::Program& program, bool outward) const;

    std::size_t edgeCount() const { return m_edges; }
    std::size_t triangleCount() const { return (m_outward.indexCount + m_inward.indexCount) / 3; }
    std::uint64_t gpuBytes() const;

private:
    struct Part {
        std::vector<gl::DrawElementsIndirect> commands;
        gl::Buffer commandBuffer;
        std::size_t firstIndex = 0, indexCount = 0;
    };
    /// What the built volumes depend on.
    struct Key {
        LightType type;
        glm::dvec3 position;
        glm::vec3 direction;
        ShadowVolumeOptions options;
        std::vector<bool> both;
        bool operator==(const Key&) const = default;
    };
    void build(FrameContext& frame, const Key& key, const std::vector<int>& excludedModels);
    void upload(FrameContext& frame, const VolumeTriangles& triangles);

    std::optional<Key> m_key;
    std::size_t m_edges = 0;
    Part m_outward, m_inward;
    gl::Buffer m_indices;
    gl::VertexArray m_vertices;
};

}  // namespace ombrage
