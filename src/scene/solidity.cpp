// SPDX-License-Identifier: MIT
#include "scene/solidity.h"

#include <numeric>
#include <unordered_map>
#include <vector>

#include "core/hash.h"
#include "scene/weld.h"

namespace ombrage {

namespace {

/// Connected parts by union-find with halved paths.
class Parts {
public:
    explicit Parts(std::size_t count) : m_parent(count) { std::iota(m_parent.begin(), m_parent.end(), 0u); }
    std::uint32_t find(std::uint32_t i) {
        for (; m_parent[i] != i; i = m_parent[i]) m_parent[i] = m_parent[m_parent[i]];
        return i;
    }
    void join(std::uint32_t a, std::uint32_t b) { m_parent[find(a)] = find(b); }

private:
    std::vector<std::uint32_t> m_parent;
};

/// Chances of two edges' counts cancelling by accident are 2^-64: sums of hashes stand for sums of edges.
bool isClosed(const Mesh& mesh, const std::vector<std::uint32_t>& welded) {
    std::uint64_t balance = 0;
    const auto edge = [](std::uint64_t from, std::uint64_t to) { return mixedBits((from << 32 | to) + 1); };
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint64_t from = welded[mesh.indices[i + k]], to = welded[mesh.indices[i + (k + 1) % 3]];
            balance += edge(from, to) - edge(to, from);
        }
    return balance == 0;
}

}  // namespace

bool isSolid(const Mesh& mesh) {
    if (mesh.indices.empty()) return false;
    const std::vector<std::uint32_t> welded = weldedVertices(mesh.positions);
    if (!isClosed(mesh, welded)) return false;

    Parts parts(mesh.positions.size());
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        parts.join(welded[mesh.indices[i]], welded[mesh.indices[i + 1]]);
        parts.join(welded[mesh.indices[i]], welded[mesh.indices[i + 2]]);
    }

    // Six times each part's volume, as signed tetrahedra from one of its own points, so that far origins cost no
    // digits.
    std::unordered_map<std::uint32_t, double> volumes;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const std::uint32_t part = parts.find(welded[mesh.indices[i]]);
        const glm::dvec3 from(mesh.positions[part]);
        const glm::dvec3 a = glm::dvec3(mesh.positions[mesh.indices[i]]) - from;
        const glm::dvec3 b = glm::dvec3(mesh.positions[mesh.indices[i + 1]]) - from;
        const glm::dvec3 c = glm::dvec3(mesh.positions[mesh.indices[i + 2]]) - from;
        volumes[part] += glm::dot(a, glm::cross(b, c));
    }
    for (const auto& [part, volume] : volumes)
        if (!(volume > 0.0)) return false;  // a sheet of two sides has none, and NaN is no volume either
    return true;
}

}  // namespace ombrage
