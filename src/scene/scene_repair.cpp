// SPDX-License-Identifier: MIT
#include "scene/scene_repair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/strings.h"
#include "scene/mesh_build.h"

namespace ombrage {

namespace {
template <int N>
bool isFinite(const glm::vec<N, float, glm::defaultp>& v) {
    for (int i = 0; i < N; ++i)
        if (!std::isfinite(v[i])) return false;
    return true;
}

template <int N>
bool allFinite(const std::vector<glm::vec<N, float, glm::defaultp>>& values) {
    return std::all_of(values.begin(), values.end(), isFinite<N>);
}

/// Compares positions by their coordinates.
bool isLess(const glm::vec3& a, const glm::vec3& b) {
    if (a.x != b.x) return a.x < b.x;
    return a.y != b.y ? a.y < b.y : a.z < b.z;
}

/// Removes triangles whose corners lie where another's do, in the same turning sense. All corners are finite.
std::size_t dropDuplicates(Mesh& mesh) {
    // The smallest corner leads; triangles are bucketed by it (counting sort), and only a bucket's own are compared.
    std::vector<std::uint32_t> order(mesh.positions.size()), place(mesh.positions.size());
    std::iota(order.begin(), order.end(), 0u);
    order.erase(
        std::remove_if(order.begin(), order.end(), [&](std::uint32_t v) { return !isFinite(mesh.positions[v]); }),
        order.end());
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return isLess(mesh.positions[a], mesh.positions[b]); });
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i > 0 && mesh.positions[order[i]] != mesh.positions[order[i - 1]]) ++count;
        place[order[i]] = count;
    }
    const std::size_t triangleCount = mesh.triangleCount();
    std::vector<std::array<std::uint32_t, 3>> corners(triangleCount);
    std::vector<std::uint32_t> starts(std::size_t(count) + 2, 0);
    for (std::size_t t = 0; t < triangleCount; ++t) {
        for (std::size_t k = 0; k < 3; ++k) corners[t][k] = place[mesh.indices[3 * t + k]];
        std::rotate(corners[t].begin(), std::min_element(corners[t].begin(), corners[t].end()), corners[t].end());
        ++starts[corners[t][0] + 1];
    }
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    std::vector<std::uint32_t> filled(starts.begin(), starts.end() - 1), bucket(triangleCount);

    // Triangles enter their buckets in order, so that the first of several stays.
    std::size_t kept = 0;
    for (std::size_t t = 0; t < triangleCount; ++t) {
        const std::uint32_t first = starts[corners[t][0]];
        std::uint32_t& end = filled[corners[t][0]];
        const bool isRepeated = std::any_of(bucket.begin() + first, bucket.begin() + end,
                                            [&](std::uint32_t other) { return corners[other] == corners[t]; });
        if (isRepeated) continue;
        bucket[end++] = std::uint32_t(t);
        for (std::size_t k = 0; k < 3; ++k) mesh.indices[3 * kept + k] = mesh.indices[3 * t + k];
        ++kept;
    }
    mesh.indices.resize(3 * kept);
    return triangleCount - kept;
}

/// How many triangles of which meshes were left out for one reason.
struct Loss {
    std::size_t count = 0;
    std::vector<std::string> meshes;

    void add(std::size_t lost, const std::string& mesh) {
        if (lost == 0) return;
        count += lost;
        meshes.push_back(mesh);
    }
    void tell(const std::string& reason, std::vector<std::string>& warnings) const {
        if (count == 0) return;
        constexpr std::size_t kNamed = 4;
        std::vector<std::string> named(meshes.begin(),
                                       meshes.begin() + std::ptrdiff_t(std::min(kNamed, meshes.size())));
        if (meshes.size() > kNamed) named.push_back("...");
        warnings.push_back(std::to_string(count) + (count == 1 ? " triangle " : " triangles ") + reason +
                           " left out (in " + join(named, ", ") + ")");
    }
};
}  // namespace

void repairScene(Scene& scene) {
    Loss bad, repeated;
    for (Mesh& mesh : scene.meshes) {
        const std::size_t badCount = dropBadTriangles(mesh), repeatedCount = dropDuplicates(mesh);
        bad.add(badCount, mesh.name);
        repeated.add(repeatedCount, mesh.name);
        const bool isSound =
            allFinite(mesh.positions) && allFinite(mesh.normals) && allFinite(mesh.tangents) && allFinite(mesh.uvs);
        if (badCount == 0 && repeatedCount == 0 && isSound) continue;

        joinVertices(mesh);
        if (allFinite(mesh.normals) && allFinite(mesh.tangents) && allFinite(mesh.uvs)) continue;
        scene.warnings.push_back("mesh '" + mesh.name +
                                 "': normals, tangents or texture coordinates that are no numbers were made anew");
        for (glm::vec2& uv : mesh.uvs)
            if (!isFinite(uv)) uv = glm::vec2(0.0f);
        completeNormals(mesh);
        makeTangents(mesh);
    }
    bad.tell("with non-finite corners or without area", scene.warnings);
    repeated.tell("that are there twice", scene.warnings);
}

}  // namespace ombrage
