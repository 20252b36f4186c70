// SPDX-License-Identifier: MIT
#include "render/faceted_mesh.h"

namespace ombrage {

FacetedMesh facet(const Mesh& mesh) {
    FacetedMesh made;
    made.source.reserve(mesh.indices.size() / 2);
    made.triangle.reserve(mesh.indices.size() / 2);
    made.indices.resize(mesh.indices.size());
    const auto add = [&](std::uint32_t vertex, std::uint32_t triangle) {
        made.source.push_back(vertex);
        made.triangle.push_back(triangle);
        return std::uint32_t(made.source.size() - 1);
    };

    // Each triangle owns its last corner; the other corners take any copy of their vertex.
    constexpr std::uint32_t kNoCopy = 0xffffffffu;
    std::vector<std::uint32_t> copyOf(mesh.positions.size(), kNoCopy);
    for (std::size_t corner = 2; corner < mesh.indices.size(); corner += 3) {
        const std::uint32_t vertex = mesh.indices[corner];
        made.indices[corner] = copyOf[vertex] = add(vertex, std::uint32_t(corner / 3));
    }
    for (std::size_t corner = 0; corner < mesh.indices.size(); ++corner) {
        const std::uint32_t vertex = mesh.indices[corner];
        if (corner % 3 == 2) {
            copyOf[vertex] = made.indices[corner];  // a copy near by in the vertex buffer, for the caches
            continue;
        }
        if (copyOf[vertex] == kNoCopy) copyOf[vertex] = add(vertex, FacetedMesh::kNoTriangle);
        made.indices[corner] = copyOf[vertex];
    }
    return made;
}

}  // namespace ombrage
