// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <ombrage/scene.h>

namespace ombrage {

/// A mesh whose triangles each have a last corner of their own, so that a flat vertex attribute can say what belongs
/// to the triangle: shaders need no gl_PrimitiveID, for which some drivers take a mesh apart. About twice the
/// vertices of a closed mesh, and never more than its corners.
struct FacetedMesh {
    static constexpr std::uint32_t kNoTriangle = 0xffffffffu;

    std::vector<std::uint32_t> source;    ///< per vertex: the mesh's vertex that it repeats
    std::vector<std::uint32_t> triangle;  ///< per vertex: the triangle whose last corner it is, or kNoTriangle
    std::vector<std::uint32_t> indices;   ///< corners in the order of the mesh's
};

FacetedMesh facet(const Mesh& mesh);

}  // namespace ombrage
