// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <ombrage/scene.h>

namespace ombrage {

/// What the edges of a mesh say about its surface, vertices at one position counting as one.
enum class MeshShape {
    Closed,      ///< every edge lies between two triangles that run through it in opposite directions
    Open,        ///< some edges have triangles on one side only
    NonManifold  ///< some edges have more than two triangles, or two that run the same way
};

/// "closed", "open", "non-manifold".
const char* meshShapeName(MeshShape shape);

struct MeshInfo {
    std::string name, material, model;  ///< of the first instance's model
    std::size_t triangles = 0, vertices = 0, instances = 0;
    std::size_t edges = 0;
    std::size_t openEdges = 0;         ///< used more often in one direction than in the other
    std::size_t nonManifoldEdges = 0;  ///< with more than two triangles, or two that run the same way
    MeshShape shape = MeshShape::Closed;
    bool hasColors = false;

    /// Every edge is used as often in one direction as in the other: shadow volumes have an inside. True for all closed
    /// meshes and for some non-manifold ones, such as two boxes that share an edge.
    bool boundsVolume() const { return openEdges == 0; }
};

/// What a scene holds, counted. Names, lights, cameras and materials are in the Scene itself.
struct SceneInfo {
    std::string contentHash;
    Bounds bounds;              ///< metres
    std::size_t triangles = 0;  ///< over all instances
    std::size_t vertices = 0;   ///< over all instances
    std::vector<MeshInfo> meshes;
};

/// Counts. Needs no OpenGL; takes a time that grows with the triangles' number (n log n).
SceneInfo describeScene(const Scene& scene);

}  // namespace ombrage
