// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

namespace ombrage {

/// Node of a bounding volume hierarchy without a stack (threaded; Smits 1998): nodes lie in depth-first order. A ray that meets
/// an inner node's box goes on with the next node; one that misses it, or has tried the triangles of a leaf, with `skip`. The
/// walk ends at the index beyond the last node.
struct BvhNode {
    glm::vec3 lower{0.0f};
    std::uint32_t skip = 0;
    glm::vec3 upper{0.0f};
    std::uint32_t leaf = 0;   ///< 0: inner; else first position in Bvh::order * 16 + number of triangles (1 to 15)

    std::uint32_t firstTriangle() const { return leaf >> 4; }
    std::uint32_t triangleCount() const { return leaf & 15u; }
};

struct Bvh {
    std::vector<BvhNode> nodes;
    std::vector<std::uint32_t> order;   ///< ids of triangles, leaf by leaf
    int depth = 0;                      ///< nodes on the longest way down; 0 when there is no triangle
};

/// Builds with Embree's binned surface-area heuristic.
/// @param triangles vertex indices
/// @param wanted ids of the triangles to hold; those with coordinates that are no numbers are left out
/// @throws Error(Environment) when Embree cannot start or has no memory, Error(Input) beyond 2^28 triangles.
Bvh buildBvh(const std::vector<glm::vec3>& positions, const std::vector<glm::uvec3>& triangles, const std::vector<std::uint32_t>& wanted);

}  // namespace ombrage
