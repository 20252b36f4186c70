// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <ombrage/scene.h>

namespace ombrage {

/// One instance in the flat arrays.
struct FlatInstance {
    std::uint32_t firstVertex = 0, vertexCount = 0;
    std::uint32_t firstTriangle = 0, triangleCount = 0;  ///< over all instances: the global triangle id
    int mesh = 0, material = 0, model = 0;
    bool casts = true, receives = true;
    bool mirrored = false;            ///< negative determinant: winding is already swapped in `triangles`
    glm::mat4 originFromLocal{1.0f};  ///< float copy of translate(-origin) * worldFromLocal
};

/// The scene's triangles in one space: world moved by a floating origin, so that floats are fine near the geometry.
/// The one source of positions for the truth, for the silhouettes and for the GPU's ray tracing.
struct FlatScene {
    glm::dvec3 origin{0.0};            ///< world position of this space's zero: the centre of the bounds
    std::vector<glm::vec3> positions;  ///< rounded once from double
    std::vector<glm::vec3> normals;    ///< unit
    std::vector<glm::vec4> tangents;
    std::vector<glm::vec2> uvs;
    std::vector<glm::vec3> colors;      ///< of the vertices, white where a mesh has none; empty when no mesh has any
    std::vector<glm::uvec3> triangles;  ///< vertex indices, counter-clockwise from outside
    std::vector<std::uint32_t> triangleInstance;
    std::vector<FlatInstance> instances;
};

FlatScene flatten(const Scene& scene);

/// Distance, in lengths of `direction`, to the first triangle that the ray meets, or infinity; both sides count, holes
/// of textures do not. Looks at every triangle: for a few rays (the truth's rays are reference/ray_scene).
double nearestHit(const FlatScene& flat, const glm::dvec3& start, const glm::dvec3& direction);

}  // namespace ombrage
