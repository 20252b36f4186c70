// SPDX-License-Identifier: MIT
#include "techniques/shared/silhouette.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <tuple>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include "scene/weld.h"

namespace ombrage {

namespace {

constexpr std::size_t kGrain = 8192;  // triangles or edges per task: some 50 microseconds of work

bool isFinite(const glm::vec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

constexpr std::size_t kBlock = 16;  // triangles that are told apart together
/// Bound on the error of a rounded plane at a rounded light, as a share of the summands' sizes: four products of two
/// rounded factors and three sums, six times 2^-24.
constexpr float kRounding = 6 * 0x1p-24f * 1.01f;

/// On which side of the line from a to b the ray from the zero passes. One that meets the line passes it on one side
/// only, whichever end is named first, so that it does not slip between two triangles.
bool passesLeft(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& direction) {
    const double side = glm::dot(glm::cross(a, b), direction);
    if (side != 0.0) return side > 0.0;
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

/// How near the way counts as touching an edge, as a share of the edge's distance: what the rasteriser rounds.
constexpr double kTouching = 1e-6;

/// Distance between the edge from a to b and the ray from the zero along a unit direction, as long as given.
double distanceToRay(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& along, double length) {
    // The edge's point nearest to the line, across the ray; then the ray's point nearest to that.
    const glm::dvec3 edge = b - a, acrossEdge = edge - glm::dot(edge, along) * along,
                     acrossA = a - glm::dot(a, along) * along;
    const double square = glm::dot(acrossEdge, acrossEdge);
    const double u = square > 0 ? std::clamp(-glm::dot(acrossA, acrossEdge) / square, 0.0, 1.0) : 0.0;
    double nearest = INFINITY;
    for (const double at : {u, 0.0, 1.0}) {
        const glm::dvec3 q = a + at * edge;
        nearest = std::min(nearest, glm::length(q - std::clamp(glm::dot(q, along), 0.0, length) * along));
    }
    return nearest;
}

/// Whether the far cap of a triangle's volume lies between a point, which has the triangle before the light, and the
/// triangle.
bool endsBefore(const VolumeEnd& end, const std::array<glm::dvec3, 3>& triangle, const glm::dvec3& p_world) {
    std::array<glm::dvec3, 3> cap;
    for (std::size_t k = 0; k < 3; ++k)
        cap[k] = triangle[k] +
                 end.distance_m * glm::normalize(triangle[k] * end.light_world.w - glm::dvec3(end.light_world));
    const glm::dvec3 normal = glm::cross(cap[1] - cap[0], cap[2] - cap[0]);
    return (glm::dot(normal, p_world - cap[0]) > 0.0) != (glm::dot(normal, triangle[0] - cap[0]) > 0.0);
}

/// One side of a triangle, to be sorted by its edge.
struct EdgeUse {
    std::uint64_t edge;  // smaller vertex in the upper half, larger in the lower
    std::uint32_t use;
    bool operator<(const EdgeUse& o) const { return edge != o.edge ? edge < o.edge : use < o.use; }
};

}  // namespace

MeshTopology::MeshTopology(const Mesh& mesh) {
    const std::vector<std::uint32_t> welded = weldedVertices(mesh.positions);
    std::vector<EdgeUse> uses;
    uses.reserve(mesh.indices.size());
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const glm::uvec3 t(mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]);
        if (!isFinite(mesh.positions[t.x]) || !isFinite(mesh.positions[t.y]) || !isFinite(mesh.positions[t.z]))
            continue;
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
            uses.push_back(
                {std::uint64_t(std::min(from, to)) << 32 | std::max(from, to), triangle * 2 + (from > to ? 1u : 0u)});
        }
    }
    tbb::parallel_sort(uses.begin(), uses.end());

    // Equal edges are neighbours now. A closed surface runs through each as often forward as backward.
    std::vector<std::uint32_t> forward, backward;
    m_pairVertices.reserve(uses.size() / 2);
    m_pairUses.reserve(uses.size() / 2);
    for (std::size_t i = 0; i < uses.size();) {
        const std::uint64_t edge = uses[i].edge;
        forward.clear();
        backward.clear();
        for (; i < uses.size() && uses[i].edge == edge; ++i)
            ((uses[i].use & 1u) != 0 ? backward : forward).push_back(uses[i].use);
        addEdge({std::uint32_t(edge >> 32), std::uint32_t(edge)}, forward, backward);
        m_openEdges += forward.size() != backward.size() ? 1 : 0;
    }

    // Rounded copies in whole blocks, the rest of the last one zero.
    const std::size_t padded = (m_planes.size() + kBlock - 1) / kBlock * kBlock;
    for (int k = 0; k < 4; ++k) {
        m_roundedPlanes[std::size_t(k)].assign(padded, 0.0f);
        for (std::size_t t = 0; t < m_planes.size(); ++t) m_roundedPlanes[std::size_t(k)][t] = float(m_planes[t][k]);
    }
}

void MeshTopology::addEdge(const glm::uvec2& vertices, const std::vector<std::uint32_t>& forward,
                           const std::vector<std::uint32_t>& backward) {
    ++m_edgeCount;
    for (std::size_t i = 0; i < std::max(forward.size(), backward.size()); ++i) {
        m_pairVertices.push_back(vertices);
        m_pairUses.emplace_back(i < forward.size() ? forward[i] : EdgePair::kNoUse,
                                i < backward.size() ? backward[i] : EdgePair::kNoUse);
    }
}

std::vector<EdgePair> MeshTopology::edgePairs() const {
    std::vector<EdgePair> pairs(m_pairUses.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i] = {m_pairVertices[i], m_pairUses[i]};
    return pairs;
}

/// The steps of appendVolume.
class VolumeBuilder {
public:
    VolumeBuilder(const MeshTopology& topology, const VolumeRequest& request)
        : m_topology(topology), m_request(request) {}

    void build(VolumeTriangles& out) {
        classify();
        if (m_request.faces == VolumeFaces::Silhouette)
            appendSilhouetteSides(out);
        else
            appendTriangleSides(out);
        if (m_request.caps) appendCaps(out);
    }

private:
    /// In single precision where that is sure of the side, in double where it is not.
    void classify() {
        const std::size_t count = m_topology.triangleCount();
        m_weight.resize(count);
        const auto light = glm::vec4(m_request.light_local);
        const auto inPlane = float(m_request.inPlane_local * 1.001),
                   rounding = kRounding + float(m_request.rounding * 1.001);
        const std::int8_t facing = m_request.weightFacing(), away = m_request.weightAway();
        const float *x = m_topology.m_roundedPlanes[0].data(), *y = m_topology.m_roundedPlanes[1].data(),
                    *z = m_topology.m_roundedPlanes[2].data(), *w = m_topology.m_roundedPlanes[3].data();
        const tbb::blocked_range<std::size_t> blocks(0, (count + kBlock - 1) / kBlock, kGrain / kBlock);
        tbb::parallel_for(blocks, [&](const auto& range) {
            for (std::size_t block = range.begin(); block != range.end(); ++block) {
                const std::size_t first = block * kBlock;
                float side[kBlock], doubt[kBlock];  // |x| + |y| + |z| is at least the normal's length
                for (std::size_t i = 0; i < kBlock; ++i) {
                    const float px = x[first + i] * light.x, py = y[first + i] * light.y, pz = z[first + i] * light.z,
                                pw = w[first + i] * light.w;
                    side[i] = px + py + pz + pw;
                    doubt[i] = rounding * (std::abs(px) + std::abs(py) + std::abs(pz) + std::abs(pw)) +
                               inPlane * (std::abs(x[first + i]) + std::abs(y[first + i]) + std::abs(z[first + i]));
                }
                for (std::size_t i = 0; i < std::min(kBlock, count - first); ++i)
                    m_weight[first + i] = side[i] > doubt[i]    ? facing
                                          : side[i] < -doubt[i] ? away
                                                                : m_request.weight(m_topology.m_planes[first + i]);
            }
        });
    }

    std::uint32_t near(std::uint32_t vertex) const { return (m_request.firstVertex + vertex) * 2; }
    std::uint32_t far(std::uint32_t vertex) const { return near(vertex) + 1; }

    /// The side below the edge from a to b of a near cap that is counter-clockwise seen from the light, so the side
    /// runs from b to a. A mirror turns it round. The far ends of a sun's side are one point (Everitt and Kilgard 2002,
    /// section 5.3).
    void appendSide(std::uint32_t a, std::uint32_t b, std::vector<std::uint32_t>& to) const {
        if (m_request.mirrored) std::swap(a, b);
        to.insert(to.end(), {near(b), near(a), far(a)});
        if (m_request.hasFarEnds()) to.insert(to.end(), {near(b), far(a), far(b)});
    }

    /// One side per count: the signed sum over the casting triangles of how often they run through the edge (Bergeron
    /// 1986; Kim et al. 2008). Sides between two triangles that face alike cancel.
    void appendSilhouetteSides(VolumeTriangles& out) const {
        const std::size_t pairs = m_topology.m_pairUses.size(), chunks = (pairs + kGrain - 1) / kGrain;
        std::vector<std::vector<std::uint32_t>> parts(chunks);
        std::vector<std::size_t> sides(chunks, 0);
        tbb::parallel_for(std::size_t(0), chunks, [&](std::size_t chunk) {
            const std::size_t end = std::min(pairs, (chunk + 1) * kGrain);
            for (std::size_t e = chunk * kGrain; e < end; ++e) {
                const glm::uvec2 use = m_topology.m_pairUses[e];
                int count = use.x != EdgePair::kNoUse ? m_weight[use.x >> 1] : 0;
                if (use.y != EdgePair::kNoUse) count -= m_weight[use.y >> 1];
                if (count == 0) continue;
                glm::uvec2 edge = m_topology.m_pairVertices[e];
                if (count < 0) std::swap(edge.x, edge.y);
                sides[chunk] += std::size_t(std::abs(count));
                for (int i = 0; i < std::abs(count); ++i) appendSide(edge.x, edge.y, parts[chunk]);
            }
        });
        for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
            out.sides.insert(out.sides.end(), parts[chunk].begin(), parts[chunk].end());
            out.edges += sides[chunk];
        }
    }

    void appendTriangleSides(VolumeTriangles& out) const {
        for (std::size_t t = 0; t < m_weight.size(); ++t) {
            if (m_weight[t] == 0) continue;
            glm::uvec3 corner = m_topology.m_triangles[t];
            if (m_weight[t] < 0) std::swap(corner.y, corner.z);
            for (int k = 0; k < 3; ++k) appendSide(corner[k], corner[(k + 1) % 3], out.sides);
            out.edges += 3;
        }
    }

    /// Light caps keep the mesh's order of corners, so that their depth has the bits of the G-buffer's.
    void appendCaps(VolumeTriangles& out) const {
        for (std::size_t t = 0; t < m_weight.size(); ++t) {
            if (m_weight[t] == 0) continue;
            const glm::uvec3 v = m_topology.m_triangles[t];
            const bool facesOut = (m_weight[t] > 0) != m_request.mirrored;
            auto& caps = facesOut ? out.lightCaps : out.inwardLightCaps;
            caps.insert(caps.end(), {near(v.x), near(v.y), near(v.z)});
            if (!m_request.hasFarEnds()) continue;
            if (facesOut)
                out.darkCaps.insert(out.darkCaps.end(), {far(v.x), far(v.z), far(v.y)});
            else
                out.darkCaps.insert(out.darkCaps.end(), {far(v.x), far(v.y), far(v.z)});
        }
    }

    const MeshTopology& m_topology;
    const VolumeRequest& m_request;
    std::vector<std::int8_t> m_weight;
};

void appendVolume(const MeshTopology& topology, const VolumeRequest& request, VolumeTriangles& out) {
    VolumeBuilder(topology, request).build(out);
}

bool touchesEdge(const MeshTopology& topology, const Mesh& mesh, const glm::dvec4& light_local,
                 const glm::dvec3& p_local) {
    const glm::dvec3 way = glm::dvec3(light_local) - p_local * light_local.w;
    const double length = glm::length(way), longest = light_local.w != 0.0 ? length : INFINITY;
    std::atomic<bool> touched = false;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, topology.triangleCount(), kGrain), [&](const auto& range) {
        for (std::size_t t = range.begin(); t != range.end() && !touched; ++t) {
            const glm::uvec3 v = topology.triangles()[t];
            for (int k = 0; k < 3; ++k) {
                const glm::dvec3 a = glm::dvec3(mesh.positions[v[k]]) - p_local,
                                 b = glm::dvec3(mesh.positions[v[(k + 1) % 3]]) - p_local;
                // In one plane with it, then near to it.
                const double square = 2 * (glm::dot(a, a) + glm::dot(b, b));
                if (std::abs(glm::dot(glm::cross(a, b), way)) > kTouching * square * length) continue;
                if (distanceToRay(a, b, way / length, longest) <= kTouching * std::sqrt(square)) touched = true;
            }
        }
    });
    return touched;
}

int volumesAround(const MeshTopology& topology, const Mesh& mesh, const VolumeRequest& request,
                  const glm::dvec3& p_local, const std::optional<VolumeEnd>& end) {
    const glm::dvec3 direction = glm::dvec3(request.light_local) - p_local * request.light_local.w;
    std::atomic<int> around = 0;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, topology.triangleCount(), kGrain), [&](const auto& range) {
        int crossed = 0;
        for (std::size_t t = range.begin(); t != range.end(); ++t) {
            // Which side of the triangle's plane the point and the light are on; only a change of sides is a crossing.
            const glm::dvec4& plane = topology.planes()[t];
            const bool lightInFront = glm::dot(plane, request.light_local) > 0.0;
            if ((glm::dot(plane, glm::dvec4(p_local, 1.0)) > 0.0) == lightInFront) continue;
            if (request.weight(plane) == 0) continue;
            // The line passes inside of all three sides, seen from the point (signed volumes of its tetrahedra).
            const glm::uvec3 v = topology.triangles()[t];
            const glm::dvec3 a = glm::dvec3(mesh.positions[v.x]) - p_local,
                             b = glm::dvec3(mesh.positions[v.y]) - p_local,
                             c = glm::dvec3(mesh.positions[v.z]) - p_local;
            const bool ab = passesLeft(a, b, direction), bc = passesLeft(b, c, direction),
                       ca = passesLeft(c, a, direction);
            if (ab != bc || bc != ca) continue;
            if (end) {
                const auto world = [&](const glm::dvec3& p) {
                    return glm::dvec3(end->worldFromLocal * glm::dvec4(p, 1.0));
                };
                if (endsBefore(*end, {world(a + p_local), world(b + p_local), world(c + p_local)}, world(p_local)))
                    continue;
            }
            ++crossed;
        }
        around += crossed;
    });
    return around;
}

}  // namespace ombrage
