// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "gl/objects.h"
#include "gl/shader_library.h"
#include "render/gpu_scene.h"
#include "techniques/shared/silhouette.h"
#include "techniques/shared/volume_params.h"

namespace ombrage {

class FrameContext;
struct GpuCaster;
struct GpuTopology;
struct LightFrame;

/// Adjacency of every mesh of a scene; shared through GpuScene::derived().
class SceneTopology {
public:
    explicit SceneTopology(const GpuScene& scene);

    const MeshTopology& mesh(int index) const { return m_meshes[std::size_t(index)]; }
    /// Of the mesh's vertices, in its own space.
    const Bounds& bounds(int index) const { return m_bounds[std::size_t(index)]; }

private:
    std::vector<MeshTopology> m_meshes;
    std::vector<Bounds> m_bounds;
};

/// Both ends of every vertex, the corner itself (w 1) and the same to be sent to the far end (w 0), one after the
/// other, so that the codes of VolumeTriangles are indices. Shared through GpuScene::derived().
struct VolumeVertices {
    explicit VolumeVertices(const GpuScene& scene);
    gl::Buffer buffer;  ///< vec4, local
};

/// What volumes consist of. All but the last are counter-clockwise seen from outside.
enum class VolumePart { Sides, LightCaps, DarkCaps, InwardLightCaps };
inline constexpr std::size_t kVolumeParts = 4;

/// Which triangles cast: those turned away from the light, where these are not enough all (see VolumeRequest::both); or
/// one kind alone, which the processor finds.
enum class CastingSide { Automatic, Away, Lit };

struct ShadowVolumeOptions {
    VolumeFaces faces = VolumeFaces::Silhouette;
    SilhouetteSource source = SilhouetteSource::Cpu;
    CastingSide casting = CastingSide::Automatic;
    std::optional<float> distance_m;  ///< where they end; endless without it
    bool slabs = false;               ///< they begin and end where ShadowVolumes::setSlabs() says, in its place

    bool end() const { return distance_m.has_value() || slabs; }

    explicit ShadowVolumeOptions(const VolumeParams& params);
    explicit ShadowVolumeOptions(CastingSide side) : casting(side) {}
    ShadowVolumeOptions() = default;
    bool operator==(const ShadowVolumeOptions&) const = default;
};

/// How volumes are drawn.
struct VolumeLook {
    const char* fragmentPath = "shared/empty.frag";
    /// Onto the near plane as seen from the light, in place of the picture as seen from the eye.
    bool ontoNearPlane = false;
    /// In the place of each triangle the tiles around it (shared/volume_tile_bounds.glsl), of ONTO_TILES pixels each.
    bool tileBounds = false;
    std::optional<float> distance_m;                           ///< of the far ends, in the place of the volumes' own
    std::vector<std::pair<std::string, std::string>> defines;  ///< for the fragment shader
};

/// What is left of an instance's volume: between two planes, dot(plane, (p, 1)) = 0, that look away from the light and
/// have it before them. Zero: begins at the casting triangles; is endless.
struct VolumeSlab {
    glm::vec4 near{0.0f}, far{0.0f};
    bool operator==(const VolumeSlab&) const = default;
};

/// Per instance, whether something is done with its volume.
using VolumeChoice = std::vector<bool>;

/// Shadow volumes of all casters of one light. Whoever finds which triangles bound them (see SilhouetteSource), the
/// positions are the G-buffer's own through ombrage/vertex.glsl, so that caps meet it bit by bit.
class ShadowVolumes {
public:
    /// Makes them anew when the light, the options or the side that the eye is on changed.
    /// @param withCaps  the instances whose caps will be drawn; empty: all. Volumes that end have theirs in any case.
    void update(FrameContext& frame, const LightFrame& light, const ShadowVolumeOptions& options,
                const VolumeChoice& withCaps = {});

    /// Where the volumes begin and end, of each instance; needed with ShadowVolumeOptions::slabs. What they consist of
    /// stays as it is.
    void setSlabs(const std::vector<VolumeSlab>& slabs);

    /// Forgets everything; call when the scene changed.
    void reset();

    /// Draws the parts from `first` to `last` of the chosen instances' volumes, with the draw state applied.
    void draw(FrameContext& frame, const LightFrame& light, VolumePart first, VolumePart last,
              const VolumeChoice& chosen, const VolumeLook& look = {}) const;

    /// Instances that cast.
    const VolumeChoice& casters() const { return m_casters; }

    /// w of points at infinity (shared/volume_ends.glsl).
    static float infinity(const FrameContext& frame);

    /// Where the indices of an instance's sides stand in indices(): the first of them, and how many. Of each side the
    /// first two are the ends of its edge, the cap's interior to the left of the way from the second to the first, as
    /// the light sees it. Known where the processor finds the silhouettes.
    std::pair<std::uint32_t, std::uint32_t> sides(std::size_t instance) const;
    const gl::Buffer& indices() const { return m_indices; }
    std::uint32_t indicesPerSide() const;

    /// The triangles turned away from the light are not enough for this instance.
    bool needsBothSides(std::size_t instance) const { return m_key->both[instance]; }

    const ShadowVolumeOptions& options() const { return m_key->options; }

    /// The edges of an instance's mesh that bound its volume, as pairs of the mesh's vertices; found on the processor.
    std::vector<glm::uvec2> silhouette(const GpuScene& scene, std::size_t instance) const;

    /// How many of the chosen instances' volumes hold the point, in the space moved by the scene's origin.
    int around(const FrameContext& frame, const LightFrame& light, const glm::vec3& p,
               const VolumeChoice& chosen) const;

    /// Puts what is known of the volumes' size into the record.
    void report(FrameContext& frame) const;

    std::uint64_t gpuBytes() const;

private:
    /// What the volumes depend on.
    struct Key {
        glm::dvec4 toward_world;  ///< the light, as LightFrame::towardInWorld()
        ShadowVolumeOptions options;
        VolumeChoice both, caps;
        bool operator==(const Key&) const = default;
        bool isSun() const { return toward_world.w == 0.0; }
    };
    VolumeRequest request(const GpuScene& scene, std::size_t instance) const;
    void buildOnCpu(FrameContext& frame);
    void buildOnGpu(FrameContext& frame);
    void prepareGeometryShader(FrameContext& frame);
    std::vector<GpuCaster> gpuCasters(const GpuScene& scene, const GpuTopology& topology) const;
    const gl::Program& program(FrameContext& frame, VolumePart part, const VolumeLook& look) const;
    void readBackSizes() const;

    std::optional<Key> m_key;
    VolumeChoice m_casters;
    gl::Buffer m_indices, m_commands, m_casterData;  ///< commands: of each part, one per instance
    gl::Buffer m_slabs;                              ///< VolumeSlab per instance
    gl::VertexArray m_vertices, m_capVertices;
    /// Indices of each command, where the processor knows them.
    mutable std::vector<std::uint32_t> m_counts;
    mutable std::size_t m_edges = 0;
};

}  // namespace ombrage
