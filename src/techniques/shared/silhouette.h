// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include <ombrage/scene.h>

namespace ombrage {

/// Which triangles meet at which edges of a mesh, vertices joined by position. Made once per mesh; holds any triangle soup.
/// Triangles with two equal corners or with coordinates that are no numbers are left out: they cast no shadow.
class MeshTopology {
public:
    explicit MeshTopology(const Mesh& mesh);

    /// Every edge is used as often in one direction as in the other: the surface has an inside.
    bool closed() const { return m_closed; }
    std::size_t triangleCount() const { return m_triangles.size(); }
    std::size_t edgeCount() const { return m_edges.size(); }

private:
    friend class VolumeBuilder;

    std::vector<glm::uvec3> m_triangles;     ///< the mesh's own vertices, in the mesh's order
    std::vector<glm::uvec2> m_edges;         ///< one vertex pair per edge; its direction counts as forward
    std::vector<std::uint32_t> m_firstUse;   ///< per edge, into m_uses; one more at the end
    std::vector<std::uint32_t> m_uses;       ///< triangle * 2, plus 1 where it runs through the edge backward
    std::vector<glm::dvec4> m_planes;        ///< per triangle: normal (not unit) and -normal . corner
    bool m_closed = true;
};

/// How the volume of one instance is to be built.
struct VolumeRequest {
    /// Towards the light in the mesh's space: (position, 1), or (direction to the sun, 0).
    glm::dvec4 light_local{0, 1, 0, 0};
    /// The mesh's space is the mirror image of the world's.
    bool mirrored = false;
    /// Both: every triangle, turned towards the light, casts. Else only those turned away from the light do, which is enough
    /// for closed meshes while neither the eye nor the light is inside.
    bool both = false;
    /// A volume of its own for every triangle instead of one from the silhouette.
    bool perTriangle = false;
    /// Caps at the casters and, but for suns, at infinity.
    bool caps = true;
    /// Added to every vertex index.
    std::uint32_t firstVertex = 0;
};

/// Triangles of shadow volumes, three codes each: vertex * 2, plus 1 for that vertex moved to infinity away from the light.
struct VolumeTriangles {
    std::vector<std::uint32_t> outward;   ///< counter-clockwise from outside the volume
    std::vector<std::uint32_t> inward;    ///< clockwise: near caps that must keep their mesh's order to meet its depth exactly
    std::size_t edges = 0;                ///< sides made: silhouette edges, counted as often as they bound a volume

    void clear();
};

/// Appends the volume of one instance to `out`.
void appendVolume(const MeshTopology& topology, const VolumeRequest& request, VolumeTriangles& out);

}  // namespace ombrage
