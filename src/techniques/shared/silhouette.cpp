// SPDX-License-Identifier: MIT
#include "techniques/shared/silhouette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

namespace ombrage {

namespace {

constexpr std::size_t kGrain = 8192;   // triangles or edges per task: some 50 microseconds of work

bool isFinite(const glm::vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

/// Per vertex the first one at the same place. Equal means equal bits, but that -0 is 0.
std::vector<std::uint32_t> weld(const std::vector<glm::vec3>& positions) {
    std::vector<std::uint32_t> order(positions.size());
    std::iota(order.begin(), order.end(), 0u);
    order.erase(std::remove_if(order.begin(), order.end(), [&](std::uint32_t v) { return !isFinite(positions[v]); }), order.end());
    tbb::parallel_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        const glm::vec3 &p = positions[a], &q = positions[b];
        if (p.x != q.x) return p.x < q.x;
        if (p.y != q.y) return p.y < q.y;
        if (p.z != q.z) return p.z < q.z;
        return a < b;
    });
    std::vector<std::uint32_t> first(positions.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        first[order[i]] = i > 0 && positions[order[i]] == positions[order[i - 1]] ? first[order[i - 1]] : order[i];
    return first;
}

/// One side of a triangle, to be sorted by its edge.
struct EdgeUse {
    std::uint64_t edge;   // smaller vertex in the upper half, larger in the lower
    std::uint32_t use;
    bool operator<(const EdgeUse& o) const { return edge != o.edge ? edge < o.edge : use < o.use; }
};

}  // namespace

MeshTopology::MeshTopology(const Mesh& mesh) {
    const std::vector<std::uint32_t> welded = weld(mesh.positions);
    std::vector<EdgeUse> uses;
    uses.reserve(mesh.indices.size());
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const glm::uvec3 t(mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]);
        if (!isFinite(mesh.positions[t.x]) || !isFinite(mesh.positions[t.y]) || !isFinite(mesh.positions[t.z])) continue;
        const glm::uvec3 w(welded[t.x], welded[t.y], welded[t.z]);
        if (w.x == w.y || w.y == w.z || w.z == w.x) continue;

        // The plane in double: its sign at the light says which way the triangle faces.
        const glm::dvec3 a(mesh.positions[t.x]);
        const glm::dvec3 n = glm::cross(glm::dvec3(mesh.positions[t.y]) - a, glm::dvec3(mesh.positions[t.z]) - a);
        m_planes.emplace_back(n, -glm::dot(n, a));

        // Its three sides under their edges.
        const auto triangle = std::uint32_t(m_triangles.size());
        m_triangles.push_back(t);
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t from = w[k], to = w[(k + 1) % 3];
            uses.push_back({std::uint64_t(std::min(from, to)) << 32 | std::max(from, to), triangle * 2 + (from > to ? 1u : 0u)});
        }
    }
    tbb::parallel_sort(uses.begin(), uses.end());

    // Equal edges are neighbours now. A closed surface runs through each as often forward as backward.
    for (std::size_t i = 0; i < uses.size();) {
        m_edges.emplace_back(std::uint32_t(uses[i].edge >> 32), std::uint32_t(uses[i].edge));
        m_firstUse.push_back(std::uint32_t(m_uses.size()));
        const std::uint64_t edge = uses[i].edge;
        int balance = 0;
        for (; i < uses.size() && uses[i].edge == edge; ++i) {
            m_uses.push_back(uses[i].use);
            balance += (uses[i].use & 1u) != 0 ? -1 : 1;
        }
        m_closed = m_closed && balance == 0;
    }
    m_firstUse.push_back(std::uint32_t(m_uses.size()));
}

void VolumeTriangles::clear() {
    outward.clear();
    inward.clear();
    edges = 0;
}

/// The steps of appendVolume.
class VolumeBuilder {
public:
    VolumeBuilder(const MeshTopology& topology, const VolumeRequest& request) : m_topology(topology), m_request(request) {}

    void build(VolumeTriangles& out) {
        classify();
        if (m_request.perTriangle)
            appendTriangleSides(out);
        else
            appendSilhouetteSides(out);
        if (m_request.caps) appendCaps(out);
    }

private:
    /// Per triangle: 1 casts as it is wound (faces the light), -1 casts turned around (faces away), 0 does not cast.
    void classify() {
        m_weight.resize(m_topology.triangleCount());
        const std::int8_t facing = m_request.both ? 1 : 0;
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, m_weight.size(), kGrain), [&](const auto& range) {
            for (std::size_t t = range.begin(); t != range.end(); ++t)
                m_weight[t] = glm::dot(m_topology.m_planes[t], m_request.light_local) > 0.0 ? facing : std::int8_t(-1);
        });
    }

    std::uint32_t near(std::uint32_t vertex) const { return (m_request.firstVertex + vertex) * 2; }
    std::uint32_t far(std::uint32_t vertex) const { return near(vertex) + 1; }

    /// The side below the edge from a to b of a near cap that is counter-clockwise seen from the light, so the side runs from b
    /// to a. A mirror turns it round. The far ends of a sun's side are one point (Everitt and Kilgard 2002, section 5.3).
    void appendSide(std::uint32_t a, std::uint32_t b, std::vector<std::uint32_t>& to) const {
        if (m_request.mirrored) std::swap(a, b);
        to.insert(to.end(), {near(b), near(a), far(a)});
        if (m_request.light_local.w != 0.0) to.insert(to.end(), {near(b), far(a), far(b)});
    }

    /// One side per count: the signed sum over the casting triangles of how often they run through the edge (Bergeron 1986; Kim
    /// et al. 2008). Sides between two triangles that face alike cancel.
    void appendSilhouetteSides(VolumeTriangles& out) const {
        const std::size_t edgeCount = m_topology.edgeCount(), chunks = (edgeCount + kGrain - 1) / kGrain;
        std::vector<std::vector<std::uint32_t>> parts(chunks);
        std::vector<std::size_t> sides(chunks, 0);
        tbb::parallel_for(std::size_t(0), chunks, [&](std::size_t chunk) {
            const std::size_t end = std::min(edgeCount, (chunk + 1) * kGrain);
            for (std::size_t e = chunk * kGrain; e < end; ++e) {
                int count = 0;
                for (std::uint32_t u = m_topology.m_firstUse[e]; u < m_topology.m_firstUse[e + 1]; ++u) {
                    const std::uint32_t use = m_topology.m_uses[u];
                    count += (use & 1u) != 0 ? -m_weight[use >> 1] : m_weight[use >> 1];
                }
                glm::uvec2 edge = m_topology.m_edges[e];
                if (count < 0) std::swap(edge.x, edge.y);
                sides[chunk] += std::size_t(std::abs(count));
                for (int i = 0; i < std::abs(count); ++i) appendSide(edge.x, edge.y, parts[chunk]);
            }
        });
        for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
            out.outward.insert(out.outward.end(), parts[chunk].begin(), parts[chunk].end());
            out.edges += sides[chunk];
        }
    }

    void appendTriangleSides(VolumeTriangles& out) const {
        for (std::size_t t = 0; t < m_weight.size(); ++t) {
            if (m_weight[t] == 0) continue;
            glm::uvec3 corner = m_topology.m_triangles[t];
            if (m_weight[t] < 0) std::swap(corner.y, corner.z);
            for (int k = 0; k < 3; ++k) appendSide(corner[k], corner[(k + 1) % 3], out.outward);
            out.edges += 3;
        }
    }

    /// Near caps keep the mesh's order of corners, so that their depth has the bits of the G-buffer's. Far caps close the
    /// volumes of lamps; a sun's sides meet in one point and need none.
    void appendCaps(VolumeTriangles& out) const {
        const bool farCaps = m_request.light_local.w != 0.0;
        for (std::size_t t = 0; t < m_weight.size(); ++t) {
            if (m_weight[t] == 0) continue;
            const glm::uvec3 v = m_topology.m_triangles[t];
            const bool facesOut = (m_weight[t] > 0) != m_request.mirrored;
            auto& caps = facesOut ? out.outward : out.inward;
            caps.insert(caps.end(), {near(v.x), near(v.y), near(v.z)});
            if (!farCaps) continue;
            if (facesOut)
                out.outward.insert(out.outward.end(), {far(v.x), far(v.z), far(v.y)});
            else
                out.outward.insert(out.outward.end(), {far(v.x), far(v.y), far(v.z)});
        }
    }

    const MeshTopology& m_topology;
    const VolumeRequest& m_request;
    std::vector<std::int8_t> m_weight;
};

void appendVolume(const MeshTopology& topology, const VolumeRequest& request, VolumeTriangles& out) {
    VolumeBuilder(topology, request).build(out);
}

}  // namespace ombrage
