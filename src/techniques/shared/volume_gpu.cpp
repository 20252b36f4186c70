// SPDX-License-Identifier: MIT
#include "techniques/shared/volume_gpu.h"

#include <numeric>

#include "techniques/shared/shadow_volume.h"

namespace ombrage {

GpuTopology::GpuTopology(const GpuScene& scene) {
    const auto& topologies = scene.derived<SceneTopology>();
    std::vector<EdgePair> allPairs;
    std::vector<glm::vec4> allPlanes;
    std::vector<std::uint32_t> pairEnds, triangleVertices;
    std::vector<glm::vec3> positions;
    const auto count = int(scene.scene().meshes.size());
    for (int m = 0; m < count; ++m) {
        const MeshTopology& topology = topologies.mesh(m);
        const std::vector<EdgePair> own = topology.edgePairs();
        meshes.push_back({std::uint32_t(allPairs.size()), std::uint32_t(own.size()), std::uint32_t(allPlanes.size()),
                          std::uint32_t(topology.triangleCount())});
        allPairs.insert(allPairs.end(), own.begin(), own.end());
        allPlanes.insert(allPlanes.end(), topology.planes().begin(), topology.planes().end());
        const std::uint32_t first = scene.meshFirstVertex(m);
        for (const EdgePair& pair : own)
            pairEnds.insert(pairEnds.end(), {first + pair.vertices.x, first + pair.vertices.y});
        const std::vector<glm::vec3>& p = scene.scene().meshes[std::size_t(m)].positions;
        for (const glm::uvec3& t : topology.triangles()) {
            triangleVertices.insert(triangleVertices.end(), {first + t.x, first + t.y, first + t.z});
            positions.insert(positions.end(), {p[t.x], p[t.y], p[t.z]});
        }
    }
    pairs = gl::Buffer::from(allPairs, "shadow volume edges");
    planes = gl::Buffer::from(allPlanes, "shadow volume planes");
    pairIndices = gl::Buffer::from(pairEnds, "shadow volume edge vertices");
    triangles = gl::Buffer::from(triangleVertices, "shadow volume triangles");
    corners = gl::Buffer::from(positions, "shadow volume corners");
    std::vector<std::uint32_t> numbers(positions.size());
    std::iota(numbers.begin(), numbers.end(), 0u);
    cornerIndices = gl::Buffer::from(numbers, "shadow volume corner numbers");
}

}  // namespace ombrage
