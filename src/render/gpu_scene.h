// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <tuple>
#include <typeindex>
#include <utility>
#include <vector>

#include "gl/objects.h"
#include "scene/flat_scene.h"

namespace ombrage {

/// Which instances a draw takes.
struct DrawFilter {
    bool castersOnly = false;
    int excludedByLight = -1;  ///< leaves out the models that this light excludes
    enum class Alpha { Any, OpaqueOnly, MaskedOnly } alpha = Alpha::Any;
    bool operator<(const DrawFilter& o) const {
        return std::tie(castersOnly, excludedByLight, alpha) < std::tie(o.castersOnly, o.excludedByLight, o.alpha);
    }
};

/// Consecutive indirect draws that share textures, alpha mode, solidity and sides.
struct DrawBatch {
    /// Of Scene::textures, -1 for none: base colour, normal, height, metallic-roughness, emissive.
    std::array<int, 5> textures{-1, -1, -1, -1, -1};
    bool solid = false;  ///< opaque, closed, not mirrored: shows no back face to who is outside
    bool bothSides = false;  ///< not solid, of a double-sided material: neither side may be culled
    std::vector<std::uint32_t> instances;
    gl::Buffer commands;
    std::size_t commandCount = 0;
    std::uint64_t triangles = 0;
};

struct DrawCounts {
    std::uint64_t draws = 0, triangles = 0;
};

/// The scene on the GPU, in local coordinates: positions and indices for depth alone, vertices with all attributes and
/// indices for surfaces, storage buffers of instances and materials. Vertex shaders get the position through
/// ombrage/vertex.glsl, the one invariant function.
class GpuScene {
public:
    /// The scene must outlive this object.
    explicit GpuScene(const Scene& scene);
    ~GpuScene();
    GpuScene(const GpuScene&) = delete;
    GpuScene& operator=(const GpuScene&) = delete;

    /// What a filter takes, grouped so that each batch is one multi-draw-indirect; kept once made.
    const std::vector<DrawBatch>& batches(const DrawFilter& filter);
    /// The same of some instances (those for which `takes` is true), made anew by every call.
    std::vector<DrawBatch> batchesOf(const DrawFilter& filter, const std::vector<bool>& takes) const;

    /// Whether no back face of the batch can be seen from `viewpoint`: a point (w 1), farther than `margin_m` from
    /// every instance's bounds, or a direction (w 0).
    bool hidesBackFaces(const DrawBatch& batch, const glm::vec4& viewpoint, float margin_m) const;

    /// Draws one, with the program in use, gl state applied and bindStorage() called; binds the vertex array (positions
    /// and what comes per draw only, without textures, when `positionsOnly`: for opaque casters) and the material
    /// textures.
    /// @param mode GL_TRIANGLES, or GL_PATCHES of three vertices
    DrawCounts draw(const DrawBatch& batch, bool positionsOnly, GLenum mode = GL_TRIANGLES);

    const Scene& scene() const { return *m_scene; }
    /// The same scene with lights and cameras elsewhere; it must outlive this object.
    void follow(const Scene& scene) { m_scene = &scene; }
    const FlatScene& flat() const { return m_flat; }
    glm::dvec3 origin() const { return m_flat.origin; }
    const Bounds& bounds() const { return m_bounds; }  ///< world
    /// Bounds in the space moved by the origin, of all casters.
    glm::vec3 casterLower() const { return m_casterLower; }
    glm::vec3 casterUpper() const { return m_casterUpper; }
    /// Of an instance, lower and upper, in the space moved by the origin.
    const std::pair<glm::vec3, glm::vec3>& instanceBounds(std::size_t instance) const {
        return m_instanceBounds[instance];
    }
    /// Whether the way from a point towards a light (position, 1) or (direction, 0) meets an instance's bounds, or
    /// nearly.
    bool isOnTheWay(std::size_t instance, const glm::vec3& from, const glm::vec4& toward) const;
    /// Whether the point is in an instance's bounds grown by a margin.
    bool isWithin(std::size_t instance, const glm::vec3& point, float margin_m) const;
    bool hasAlphaMask() const { return m_hasAlphaMask; }
    /// Some mesh has colours: the full vertex array then has them at location 11, white for the other meshes.
    bool hasVertexColors() const { return bool(m_colors); }
    /// Whether lighting has any of it to do.
    bool hasSpecular() const { return m_hasSpecular; }
    bool hasEmission() const { return m_hasEmission; }
    bool hasLightExceptions() const {
        return m_hasLightExceptions;
    }  ///< instances that receive no shadow, or not every light

    const gl::Buffer& vertices() const { return m_positions; }  ///< vec3 local, tightly packed
    const gl::Buffer& indices() const { return m_indices; }     ///< uint32, global vertex indices
    const gl::Buffer& instanceStorage() const { return m_instances; }
    const gl::Buffer& materialStorage() const { return m_materials; }
    std::uint32_t meshFirstVertex(int mesh) const { return m_meshFirstVertex[std::size_t(mesh)]; }
    std::uint32_t meshFirstIndex(int mesh) const { return m_meshFirstIndex[std::size_t(mesh)]; }

    /// A vertex array with the attributes of ombrage/vertex.glsl that come per draw added; binding 2 is theirs.
    gl::VertexArray vertexArray(std::vector<gl::VertexBinding> bindings, std::vector<gl::VertexAttribute> attributes,
                                const gl::Buffer& indices) const;

    /// Binds the storage buffers that ombrage/instances.glsl and light.glsl read.
    void bindStorage() const;

    /// Texture object of Scene::textures[index].
    const gl::Texture& texture(int index) const { return m_textures[std::size_t(index)]; }

    std::uint64_t gpuBytes() const;

    /// What techniques derive from the scene's geometry (adjacency, a ray-tracing tree): made by T(const GpuScene&) at
    /// first use, shared by all of them and kept as long as the scene.
    template <typename T>
    T& derived() const {
        std::shared_ptr<void>& slot = m_derived[std::type_index(typeid(T))];
        if (!slot) slot = std::make_shared<T>(*this);
        return *static_cast<T*>(slot.get());
    }

private:
    const Scene* m_scene;
    FlatScene m_flat;
    Bounds m_bounds;
    glm::vec3 m_casterLower{0.0f}, m_casterUpper{0.0f};
    bool m_hasAlphaMask = false, m_hasSpecular = false, m_hasEmission = false, m_hasLightExceptions = false;
    std::vector<DrawBatch> makeBatches(const DrawFilter& filter, const std::vector<bool>* takes) const;
    void uploadMeshes();
    void uploadSurfaces();
    void uploadInstances();
    void uploadMaterials();

    std::vector<std::uint32_t> m_meshFirstVertex, m_meshFirstIndex;
    std::vector<bool> m_meshIsSolid;
    std::vector<std::pair<glm::vec3, glm::vec3>> m_instanceBounds;
    gl::Buffer m_positions, m_indices;
    gl::Buffer m_surfaceVertices, m_surfaceIndices;  ///< as FacetedMesh has them, in the same order of triangles
    gl::Buffer m_colors;                             ///< half floats; empty when no mesh has any
    gl::Buffer m_instances, m_materials, m_triangles, m_exclusions;
    gl::VertexArray m_positionArray, m_fullArray;
    std::vector<gl::Texture> m_textures;
    std::map<DrawFilter, std::vector<DrawBatch>> m_batches;
    mutable std::map<std::type_index, std::shared_ptr<void>> m_derived;
};

}  // namespace ombrage
