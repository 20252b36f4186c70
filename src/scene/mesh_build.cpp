// SPDX-License-Identifier: MIT
#include "scene/mesh_build.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numeric>
#include <type_traits>
#include <unordered_map>
#include <utility>

#include "scene/weld.h"

namespace ombrage {

namespace {
/// Above this many corners at one position all faces are averaged: comparing each with each would take too long.
constexpr std::size_t kMostCorners = 256;

bool isFinite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

glm::dvec3 cornerPosition(const Mesh& mesh, std::size_t corner) {
    return glm::dvec3(mesh.positions[mesh.indices[corner]]);
}

glm::dvec3 faceCross(const Mesh& mesh, std::size_t face) {
    const glm::dvec3 a = cornerPosition(mesh, 3 * face);
    return glm::cross(cornerPosition(mesh, 3 * face + 1) - a, cornerPosition(mesh, 3 * face + 2) - a);
}

bool usable(const glm::vec3& normal) {
    return isFinite(normal) && glm::dot(normal, normal) > 1e-12f;
}

glm::vec3 anyPerpendicular(const glm::vec3& n) {
    const glm::vec3 axis = std::abs(n.x) < 0.6f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    return glm::normalize(glm::cross(axis, n));
}

/// Adds a copy of a vertex without its tangent; returns its index.
std::uint32_t copyVertex(Mesh& mesh, std::uint32_t vertex) {
    mesh.positions.push_back(glm::vec3(mesh.positions[vertex]));
    mesh.normals.push_back(glm::vec3(mesh.normals[vertex]));
    if (!mesh.uvs.empty()) mesh.uvs.push_back(glm::vec2(mesh.uvs[vertex]));
    if (!mesh.colors.empty()) mesh.colors.push_back(glm::vec3(mesh.colors[vertex]));
    return std::uint32_t(mesh.positions.size() - 1);
}

/// Corners grouped by position: corner numbers in `order`, each group from starts[g] to starts[g + 1]. Groups may be
/// empty.
struct CornerGroups {
    std::vector<std::uint32_t> order;
    std::vector<std::uint32_t> starts;
};

CornerGroups groupByPosition(const Mesh& mesh) {
    // A counting sort of the corners by the first vertex at their position; other vertices have no corners.
    const std::vector<std::uint32_t> welded = weldedVertices(mesh.positions);
    CornerGroups groups;
    groups.starts.assign(mesh.positions.size() + 1, 0);
    for (const std::uint32_t vertex : mesh.indices) ++groups.starts[welded[vertex] + 1];
    std::partial_sum(groups.starts.begin(), groups.starts.end(), groups.starts.begin());
    std::vector<std::uint32_t> next(groups.starts.begin(), groups.starts.end() - 1);
    groups.order.resize(mesh.indices.size());
    for (std::size_t corner = 0; corner < mesh.indices.size(); ++corner)
        groups.order[next[welded[mesh.indices[corner]]]++] = std::uint32_t(corner);
    return groups;
}

/// The angle of a triangle at one of its corners.
double cornerAngle_rad(const Mesh& mesh, std::size_t corner) {
    const std::size_t face = corner / 3, k = corner % 3;
    const glm::dvec3 p = cornerPosition(mesh, corner);
    const glm::dvec3 a = cornerPosition(mesh, 3 * face + (k + 1) % 3) - p;
    const glm::dvec3 b = cornerPosition(mesh, 3 * face + (k + 2) % 3) - p;
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// A smooth normal for every corner.
std::vector<glm::vec3> smoothCornerNormals(const Mesh& mesh) {
    const std::size_t faceCount = mesh.triangleCount();
    std::vector<glm::dvec3> faceNormals(faceCount);
    for (std::size_t f = 0; f < faceCount; ++f) faceNormals[f] = glm::normalize(faceCross(mesh, f));
    std::vector<double> angles(mesh.indices.size());
    for (std::size_t c = 0; c < angles.size(); ++c) angles[c] = cornerAngle_rad(mesh, c);

    const double crease = std::cos(kCreaseAngle_deg * 3.14159265358979323846 / 180.0);
    const CornerGroups groups = groupByPosition(mesh);
    std::vector<glm::vec3> normals(mesh.indices.size());
    for (std::size_t g = 0; g + 1 < groups.starts.size(); ++g) {
        const std::uint32_t first = groups.starts[g], last = groups.starts[g + 1];
        const bool averageAll = last - first > kMostCorners;
        for (std::uint32_t i = first; i < last; ++i) {
            const glm::dvec3& own = faceNormals[groups.order[i] / 3];
            // Sum the faces around the position that bend less than the crease angle from this one.
            glm::dvec3 sum(0.0);
            for (std::uint32_t j = first; j < last; ++j) {
                const std::uint32_t other = groups.order[j];
                const glm::dvec3& n = faceNormals[other / 3];
                if (averageAll || glm::dot(own, n) > crease) sum += n * angles[other];
            }
            const double length = glm::length(sum);
            const glm::vec3 normal(length > 1e-9 ? sum / length : own);
            normals[groups.order[i]] = normal;
            if (averageAll) {
                for (std::uint32_t j = first; j < last; ++j) normals[groups.order[j]] = normal;
                break;
            }
        }
    }
    return normals;
}
}  // namespace

std::size_t dropBadTriangles(Mesh& mesh) {
    std::size_t kept = 0;
    const std::size_t count = mesh.triangleCount();
    for (std::size_t f = 0; f < count; ++f) {
        bool good = true;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t vertex = mesh.indices[3 * f + k];
            good = good && vertex < mesh.positions.size() && isFinite(mesh.positions[vertex]);
        }
        // The double cross product of float corners is zero only when they lie on a line or nearly underflow.
        if (good) {
            const glm::dvec3 cross = faceCross(mesh, f);
            good = glm::dot(cross, cross) > 0.0 && std::isfinite(glm::dot(cross, cross));
        }
        if (!good) continue;
        for (std::size_t k = 0; k < 3; ++k) mesh.indices[3 * kept + k] = mesh.indices[3 * f + k];
        ++kept;
    }
    mesh.indices.resize(3 * kept);
    return count - kept;
}

void joinVertices(Mesh& mesh) {
    // The bits of all attributes of a vertex, in one fixed record (missing attributes are zero).
    using Record = std::array<std::uint32_t, 15>;
    const auto recordOf = [&](std::uint32_t v) {
        std::array<float, 15> values{};
        for (int i = 0; i < 3; ++i) values[std::size_t(i)] = mesh.positions[v][i];
        for (int i = 0; i < 3 && !mesh.normals.empty(); ++i) values[std::size_t(3 + i)] = mesh.normals[v][i];
        for (int i = 0; i < 4 && !mesh.tangents.empty(); ++i) values[std::size_t(6 + i)] = mesh.tangents[v][i];
        for (int i = 0; i < 2 && !mesh.uvs.empty(); ++i) values[std::size_t(10 + i)] = mesh.uvs[v][i];
        for (int i = 0; i < 3 && !mesh.colors.empty(); ++i) values[std::size_t(12 + i)] = mesh.colors[v][i];
        Record record;
        std::memcpy(record.data(), values.data(), sizeof record);
        return record;
    };
    struct Hash {
        std::size_t operator()(const Record& record) const {
            std::uint64_t h = 0xcbf29ce484222325ull;
            for (const std::uint32_t word : record) h = (h ^ word) * 0x9e3779b97f4a7c15ull, h ^= h >> 29;
            return std::size_t(h);
        }
    };
    std::unordered_map<Record, std::uint32_t, Hash> numbers;
    numbers.reserve(mesh.positions.size());
    std::vector<std::uint32_t> kept;
    constexpr std::uint32_t kUnseen = 0xffffffffu;
    std::vector<std::uint32_t> newIndex(mesh.positions.size(), kUnseen);
    for (std::uint32_t& index : mesh.indices) {
        if (newIndex[index] == kUnseen) {
            const auto [found, isNew] = numbers.try_emplace(recordOf(index), std::uint32_t(kept.size()));
            if (isNew) kept.push_back(index);
            newIndex[index] = found->second;
        }
        index = newIndex[index];
    }
    const auto gather = [&](auto& values) {
        if (values.empty()) return;
        std::remove_reference_t<decltype(values)> result;
        result.reserve(kept.size());
        for (const std::uint32_t v : kept) result.push_back(values[v]);
        values = std::move(result);
    };
    gather(mesh.positions);
    gather(mesh.normals);
    gather(mesh.tangents);
    gather(mesh.uvs);
    gather(mesh.colors);
}

void completeNormals(Mesh& mesh) {
    mesh.normals.resize(mesh.positions.size(), glm::vec3(0.0f));
    const bool complete = std::all_of(mesh.normals.begin(), mesh.normals.end(), usable);
    if (!complete) {
        const std::vector<glm::vec3> cornerNormals = smoothCornerNormals(mesh);
        const std::size_t originalCount = mesh.positions.size();
        std::vector<char> missing(originalCount);
        for (std::size_t v = 0; v < originalCount; ++v) missing[v] = usable(mesh.normals[v]) ? 0 : 1;

        // The first corner gives the vertex its normal; corners that differ look for, or make, a copy of it.
        constexpr std::uint32_t kNone = 0xffffffffu;
        std::vector<std::uint32_t> nextCopy(originalCount, kNone);
        for (std::size_t c = 0; c < mesh.indices.size(); ++c) {
            std::uint32_t vertex = mesh.indices[c];
            if (vertex >= originalCount || !missing[vertex]) continue;
            const glm::vec3 normal = cornerNormals[c];
            if (missing[vertex] == 1) {
                missing[vertex] = 2;
                mesh.normals[vertex] = normal;
            }
            while (mesh.normals[vertex] != normal && nextCopy[vertex] != kNone) vertex = nextCopy[vertex];
            if (mesh.normals[vertex] != normal) {
                const std::uint32_t copy = copyVertex(mesh, vertex);
                mesh.normals[copy] = normal;
                nextCopy[vertex] = copy;
                nextCopy.push_back(kNone);
                vertex = copy;
            }
            mesh.indices[c] = vertex;
        }
        mesh.tangents.clear();
    }
    for (glm::vec3& n : mesh.normals) n = usable(n) ? glm::normalize(n) : glm::vec3(0, 1, 0);
}

void makeTangents(Mesh& mesh) {
    mesh.uvs.resize(mesh.positions.size(), glm::vec2(0.0f));
    const std::size_t faceCount = mesh.triangleCount();

    // Per face the direction of growing u times the face's area, and whether u, v turn as on the paper (v downwards).
    std::vector<glm::vec3> faceTangents(faceCount, glm::vec3(0.0f));
    std::vector<signed char> faceSigns(faceCount, 0);
    for (std::size_t f = 0; f < faceCount; ++f) {
        const std::uint32_t* i = &mesh.indices[3 * f];
        const glm::dvec2 u1 = glm::dvec2(mesh.uvs[i[1]]) - glm::dvec2(mesh.uvs[i[0]]);
        const glm::dvec2 u2 = glm::dvec2(mesh.uvs[i[2]]) - glm::dvec2(mesh.uvs[i[0]]);
        const glm::dvec3 p0(mesh.positions[i[0]]);
        const glm::dvec3 e1 = glm::dvec3(mesh.positions[i[1]]) - p0, e2 = glm::dvec3(mesh.positions[i[2]]) - p0;
        const double area = u1.x * u2.y - u2.x * u1.y;
        if (!std::isfinite(area) || std::abs(area) < 1e-20) continue;
        const glm::dvec3 t = (e1 * u2.y - e2 * u1.y) / area;
        const double length = glm::length(t);
        if (!(length > 0.0) || !std::isfinite(length)) continue;
        faceTangents[f] = glm::vec3(t / length * glm::length(glm::cross(e1, e2)));
        faceSigns[f] = area < 0.0 ? 1 : -1;
    }

    // One copy of a vertex per handedness; vertices without any keep the sign 0 for now.
    std::vector<signed char> signs(mesh.positions.size(), 0);
    std::vector<std::uint32_t> twin(mesh.positions.size(), 0xffffffffu);
    for (std::size_t c = 0; c < mesh.indices.size(); ++c) {
        const signed char sign = faceSigns[c / 3];
        const std::uint32_t vertex = mesh.indices[c];
        if (sign == 0) continue;
        if (signs[vertex] == 0) signs[vertex] = sign;
        if (signs[vertex] == sign) continue;
        if (twin[vertex] == 0xffffffffu) {
            twin[vertex] = copyVertex(mesh, vertex);
            signs.push_back(sign);
            twin.push_back(0xffffffffu);
        }
        mesh.indices[c] = twin[vertex];
    }

    // Sum over the faces, then make perpendicular to the normal (Gram-Schmidt).
    std::vector<glm::dvec3> sums(mesh.positions.size(), glm::dvec3(0.0));
    for (std::size_t c = 0; c < mesh.indices.size(); ++c) sums[mesh.indices[c]] += glm::dvec3(faceTangents[c / 3]);
    mesh.tangents.resize(mesh.positions.size());
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const glm::dvec3 n(mesh.normals[v]);
        const glm::dvec3 t = sums[v] - n * glm::dot(n, sums[v]);
        const double length = glm::length(t);
        const bool good = length > 1e-6 * glm::length(sums[v]) && length > 0.0;
        mesh.tangents[v] =
            glm::vec4(good ? glm::vec3(t / length) : anyPerpendicular(mesh.normals[v]), signs[v] < 0 ? -1.0f : 1.0f);
    }
}

}  // namespace ombrage
