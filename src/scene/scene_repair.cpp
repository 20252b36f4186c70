// SPDX-License-Identifier: MIT
#include "scene/scene_repair.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/strings.h"
#include "scene/archive.h"
#include "scene/load_record.h"
#include "scene/mesh_build.h"
#include "scene/scene_fields.h"

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

/// The number of each vertex's place; vertices at the same one share it. What is not finite has none.
std::vector<std::uint32_t> placesOf(const Mesh& mesh) {
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
    return place;
}

/// Removes triangles whose corners lie where another's do, in the same turning sense. All corners are finite.
std::size_t dropDuplicates(Mesh& mesh) {
    // A table of the triangles met so far, open to the next free slot: a fan's triangles all share a corner, so
    // sorting them by one would compare each with each.
    using Corners = std::array<std::uint32_t, 3>;
    constexpr std::uint32_t kFree = 0xffffffffu;
    const std::vector<std::uint32_t> place = placesOf(mesh);
    const std::size_t triangleCount = mesh.triangleCount();
    std::vector<Corners> kept;
    kept.reserve(triangleCount);
    std::vector<std::uint32_t> table(std::bit_ceil(2 * triangleCount + 1), kFree);
    for (std::size_t t = 0; t < triangleCount; ++t) {
        // The smallest corner leads, so that turned triangles are equal.
        Corners corners{};
        for (std::size_t k = 0; k < 3; ++k) corners[k] = place[mesh.indices[3 * t + k]];
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        std::size_t slot = std::size_t(fingerprintOf(corners.data(), sizeof corners)[0]) & (table.size() - 1);
        while (table[slot] != kFree && kept[table[slot]] != corners) slot = (slot + 1) & (table.size() - 1);
        if (table[slot] != kFree) continue;

        table[slot] = std::uint32_t(kept.size());
        for (std::size_t k = 0; k < 3; ++k) mesh.indices[3 * kept.size() + k] = mesh.indices[3 * t + k];
        kept.push_back(corners);
    }
    mesh.indices.resize(3 * kept.size());
    return triangleCount - kept.size();
}

/// Numbers of materials that look the same, whatever their names.
std::vector<int> looksOf(const Scene& scene) {
    std::map<std::string, int> numbers;
    std::vector<int> looks;
    for (Material material : scene.materials) {
        material.name.clear();
        std::string bytes;
        const auto append = [&](const void* data, std::size_t size) {
            bytes.append(static_cast<const char*>(data), size);
        };
        ArchiveWriter archive(append);
        archive(material);
        looks.push_back(numbers.try_emplace(std::move(bytes), int(numbers.size())).first->second);
    }
    return looks;
}

bool isSameShape(const Mesh& a, const Mesh& b) {
    return a.positions == b.positions && a.normals == b.normals && a.tangents == b.tangents && a.uvs == b.uvs &&
           a.colors == b.colors && a.indices == b.indices;
}

/// Removes instances that no picture tells from one before them: of one model and place, shape and look. Thousands of
/// them on one spot, as broken exporters write them, would each be drawn over all the others.
std::size_t dropRepeatedInstances(Scene& scene) {
    // Animations name instances by their numbers, and may move one of two away.
    for (const Animation& animation : scene.animations)
        if (!animation.instances.empty()) return 0;
    const std::vector<int> looks = looksOf(scene);
    std::vector<Fingerprint> shapes;
    for (const Mesh& mesh : scene.meshes)
        shapes.push_back(fingerprintOf(mesh.positions.data(), mesh.positions.size() * sizeof(glm::vec3)));

    using Key = std::tuple<int, int, Fingerprint, std::array<double, 16>>;
    std::map<Key, std::vector<int>> meshesAt;
    const auto isRepeated = [&](const Instance& instance) {
        const Mesh& mesh = scene.meshes[std::size_t(instance.mesh)];
        std::array<double, 16> place{};
        std::copy_n(&instance.worldFromLocal[0][0], 16, place.begin());
        if (std::any_of(place.begin(), place.end(), [](double value) { return std::isnan(value); })) return false;
        std::vector<int>& others =
            meshesAt[{instance.model, looks[std::size_t(mesh.material)], shapes[std::size_t(instance.mesh)], place}];
        for (const int other : others)
            if (other == instance.mesh || isSameShape(scene.meshes[std::size_t(other)], mesh)) return true;
        // Meshes that differ in all but their corners are few; the search among them stays bounded anyway.
        constexpr std::size_t kMostCompared = 16;
        if (others.size() < kMostCompared) others.push_back(instance.mesh);
        return false;
    };
    return std::erase_if(scene.instances, isRepeated);
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
    if (const std::size_t count = dropRepeatedInstances(scene); count > 0)
        scene.warnings.push_back(std::to_string(count) + (count == 1 ? " part that repeats" : " parts that repeat") +
                                 " another at the same place left out");
    bad.tell("with non-finite corners or without area", scene.warnings);
    repeated.tell("that are there twice", scene.warnings);
}

}  // namespace ombrage
