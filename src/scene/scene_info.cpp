// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>

#include <ombrage/scene_info.h>
#include <tbb/parallel_for.h>

#include "scene/weld.h"

namespace ombrage {

namespace {
void countEdges(const Mesh& mesh, MeshInfo& info) {
    // Every side of every triangle, as (smaller corner, larger corner) and the direction in which it runs.
    struct Side {
        std::uint64_t key;
        int direction;
    };
    const std::vector<std::uint32_t> welded = weldedVertices(mesh.positions);
    std::vector<Side> sides;
    sides.reserve(mesh.indices.size());
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        std::uint32_t corner[3];
        for (std::size_t k = 0; k < 3; ++k) corner[k] = welded[mesh.indices[i + k]];
        if (corner[0] == corner[1] || corner[1] == corner[2] || corner[0] == corner[2]) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint64_t a = corner[k], b = corner[(k + 1) % 3];
            sides.push_back({std::min(a, b) << 32 | std::max(a, b), a < b ? 1 : -1});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.key < b.key; });

    // An edge is a run of equal keys.
    for (std::size_t begin = 0; begin < sides.size();) {
        std::size_t end = begin;
        int balance = 0;
        for (; end < sides.size() && sides[end].key == sides[begin].key; ++end) balance += sides[end].direction;
        ++info.edges;
        if (balance != 0) ++info.openEdges;
        if (end - begin > 2 || (end - begin == 2 && balance != 0)) ++info.nonManifoldEdges;
        begin = end;
    }
    info.shape =
        info.nonManifoldEdges > 0 ? MeshShape::NonManifold : (info.openEdges > 0 ? MeshShape::Open : MeshShape::Closed);
}
}  // namespace

const char* meshShapeName(MeshShape shape) {
    switch (shape) {
        case MeshShape::Closed:
            return "closed";
        case MeshShape::Open:
            return "open";
        case MeshShape::NonManifold:
            return "non-manifold";
    }
    return "";
}

SceneInfo describeScene(const Scene& scene) {
    SceneInfo info;
    info.contentHash = contentHash(scene);
    info.bounds = scene.bounds();
    info.triangles = scene.triangleCount();
    info.meshes.resize(scene.meshes.size());
    tbb::parallel_for(std::size_t(0), scene.meshes.size(), [&](std::size_t i) {
        const Mesh& mesh = scene.meshes[i];
        MeshInfo& out = info.meshes[i];
        out.name = mesh.name;
        out.material = scene.materials[std::size_t(mesh.material)].name;
        out.triangles = mesh.triangleCount();
        out.vertices = mesh.positions.size();
        out.hasColors = !mesh.colors.empty();
        countEdges(mesh, out);
    });
    for (const Instance& instance : scene.instances) {
        MeshInfo& mesh = info.meshes[std::size_t(instance.mesh)];
        if (mesh.instances++ == 0) mesh.model = scene.models[std::size_t(instance.model)].name;
        info.vertices += mesh.vertices;
    }
    return info;
}

}  // namespace ombrage
