// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include <ombrage/scene.h>

namespace ombrage {

/// One forward and one backward use of an edge, or one of them: what the GPU makes sides of. An edge with more uses is
/// several pairs; which uses go together does not matter, as their counts add up.
struct EdgePair {
    glm::uvec2 vertices;  ///< the edge's ends; this direction counts as forward
    glm::uvec2 uses;      ///< forward, backward: triangle * 2, plus 1 for backward; kNoUse for none
    static constexpr std::uint32_t kNoUse = 0xffffffffu;
};

/// Which triangles meet at which edges of a mesh, vertices joined by position. Made once per mesh; holds any triangle
/// soup. Triangles with two equal corners or with coordinates that are no numbers are left out: they cast no shadow.
class MeshTopology {
public:
    explicit MeshTopology(const Mesh& mesh);

    /// Every edge is used as often in one direction as in the other: the surface has an inside.
    bool closed() const { return m_openEdges == 0; }
    /// Edges of which that is not so.
    std::size_t openEdgeCount() const { return m_openEdges; }
    std::size_t triangleCount() const { return m_triangles.size(); }
    std::size_t edgeCount() const { return m_edgeCount; }

    /// The mesh's own vertices, in the mesh's order.
    const std::vector<glm::uvec3>& triangles() const { return m_triangles; }
    /// Per triangle: normal (not unit) and -normal . corner.
    const std::vector<glm::dvec4>& planes() const { return m_planes; }
    /// The edges' pairs, one edge after the other.
    std::vector<EdgePair> edgePairs() const;

private:
    friend class VolumeBuilder;
    /// Joins the uses of one edge to pairs.
    void addEdge(const glm::uvec2& vertices, const std::vector<std::uint32_t>& forward,
                 const std::vector<std::uint32_t>& backward);

    std::vector<glm::uvec3> m_triangles;
    std::vector<glm::dvec4> m_planes;
    std::array<std::vector<float>, 4> m_roundedPlanes;   ///< x, y, z, w of the planes, to be read in fours
    std::vector<glm::uvec2> m_pairVertices, m_pairUses;  ///< as EdgePair; apart, because few vertices are looked at
    std::size_t m_edgeCount = 0;
    std::size_t m_openEdges = 0;
};

/// Whose edges are extruded: every triangle's, those of the triangles that are enough (see VolumeRequest::both), or the
/// silhouette.
enum class VolumeFaces { All, Facing, Silhouette };

/// How the volume of one instance is to be built.
struct VolumeRequest {
    /// Towards the light in the mesh's space: (position, 1), or (direction to the sun, 0).
    glm::dvec4 light_local{0, 1, 0, 0};
    /// A triangle whose plane passes nearer to the light than this casts nothing: no ray to the light crosses it.
    double inPlane_local = 0;
    double rounding = 0;  ///< more of that, as a share of the sizes of what dot(plane, light) sums up
    /// The mesh's space is the mirror image of the world's.
    bool mirrored = false;
    /// Both: every triangle, turned towards the light, casts. Else only those turned away from the light do, which is
    /// enough for closed meshes while neither the eye nor the light is inside.
    bool both = false;
    /// In the place of those turned away, only the triangles that face the light cast.
    bool litOnly = false;
    VolumeFaces faces = VolumeFaces::Silhouette;
    /// Sides end at a distance, so that even a sun's have four corners and a dark cap.
    bool finite = false;
    bool caps = true;
    /// Added to every vertex index.
    std::uint32_t firstVertex = 0;

    /// All far ends of an endless volume of a sun are one point: sides are triangles, and there is nothing to close.
    bool hasFarEnds() const { return finite || light_local.w != 0.0; }
    /// Per triangle: 1 casts as it is wound (faces the light), -1 casts turned around (faces away), 0 does not cast.
    std::int8_t weight(const glm::dvec4& plane) const {
        const double side = glm::dot(plane, light_local);
        const double doubt = rounding * glm::dot(glm::abs(plane), glm::abs(light_local));
        if (std::abs(side) <= inPlane_local * glm::length(glm::dvec3(plane)) + doubt) return 0;
        return side > 0.0 ? weightFacing() : weightAway();
    }
    std::int8_t weightFacing() const { return both || litOnly || faces == VolumeFaces::All ? 1 : 0; }
    std::int8_t weightAway() const { return litOnly ? 0 : -1; }
};

/// Triangles of shadow volumes, three codes each: vertex * 2, plus 1 for that vertex at the far end. All but the inward
/// light caps are counter-clockwise seen from outside the volume.
struct VolumeTriangles {
    std::vector<std::uint32_t> sides;
    /// The casting triangles themselves, in their mesh's order of corners to meet its depth exactly, which makes some
    /// of them clockwise.
    std::vector<std::uint32_t> lightCaps, inwardLightCaps;
    std::vector<std::uint32_t> darkCaps;
    std::size_t edges = 0;  ///< sides made: silhouette edges, counted as often as they bound a volume
};

/// Appends the volume of one instance to `out`.
void appendVolume(const MeshTopology& topology, const VolumeRequest& request, VolumeTriangles& out);

/// Whether the way from a point to the light touches an edge of the mesh, or nearly: then the point lies on the border
/// of a volume, and whether rays from it start in there depends on where they go.
bool touchesEdge(const MeshTopology& topology, const Mesh& mesh, const glm::dvec4& light_local,
                 const glm::dvec3& p_local);

/// Where volumes end: each vertex's far end lies so far from it, along the light's ray through it.
struct VolumeEnd {
    double distance_m = 0;
    glm::dvec4 light_world{0, 1, 0, 0};  ///< towards it, as VolumeRequest::light_local
    glm::dmat4 worldFromLocal{1.0};
};

/// How many volumes of casting triangles hold a point: casting triangles on the way from it to the light, without those
/// whose volume ends before.
int volumesAround(const MeshTopology& topology, const Mesh& mesh, const VolumeRequest& request,
                  const glm::dvec3& p_local, const std::optional<VolumeEnd>& end = {});

}  // namespace ombrage
