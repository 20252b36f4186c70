// SPDX-License-Identifier: MIT
#include <ombrage/displace.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include <ombrage/error.h>

#include "scene/mesh_build.h"
#include "scene/texture_lookup.h"

namespace ombrage {
namespace {

constexpr float kLongestEdge_texels = 1.5f;

glm::vec2 sizeOf(const Texture& texture) {
    return {texture.width, texture.height};
}

float crossOf(glm::vec2 a, glm::vec2 b) {
    return a.x * b.y - a.y * b.x;
}

/// Areas of a triangle in the mesh's own space and in texture coordinates.
struct Areas {
    float local, uv;
};

Areas areasOf(const Mesh& mesh, std::size_t triangle) {
    const std::uint32_t* i = &mesh.indices[3 * triangle];
    const glm::vec3 a = mesh.positions[i[0]];
    const glm::vec2 c = mesh.uvs[i[0]];
    return {glm::length(glm::cross(mesh.positions[i[1]] - a, mesh.positions[i[2]] - a)) / 2,
            std::abs(crossOf(mesh.uvs[i[1]] - c, mesh.uvs[i[2]] - c)) / 2};
}

double triangleTexels(const Mesh& mesh, const Texture& heights) {
    double sum = 0;
    for (std::size_t t = 0; t < mesh.triangleCount(); ++t)
        sum += double(areasOf(mesh, t).uv) * double(heights.width) * double(heights.height);
    return sum;
}

/// Per vertex how long a unit of texture coordinates is: mean over the triangles around it, 0 where they have no area
/// in the texture.
std::vector<float> lengthOfUnit(const Mesh& mesh) {
    std::vector<float> local(mesh.positions.size(), 0.0f), uv(mesh.positions.size(), 0.0f);
    for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
        const Areas areas = areasOf(mesh, t);
        for (int k = 0; k < 3; ++k) {
            local[mesh.indices[3 * t + k]] += areas.local;
            uv[mesh.indices[3 * t + k]] += areas.uv;
        }
    }
    for (std::size_t v = 0; v < local.size(); ++v) local[v] = uv[v] > 0 ? std::sqrt(local[v] / uv[v]) : 0.0f;
    return local;
}

/// A mesh whose long edges are halved together with all triangles at them, so that no vertex comes to lie inside an
/// edge.
class Division {
public:
    Division(Mesh& mesh, glm::vec2 texels) : m_mesh(mesh), m_texels(texels), m_unit(lengthOfUnit(mesh)) {}

    /// Halves every edge that is too long once. False if there is none.
    bool halve() {
        m_middles.clear();
        std::vector<std::uint32_t> made;
        made.reserve(m_mesh.indices.size() * 4);
        for (std::size_t t = 0; t < m_mesh.triangleCount(); ++t) {
            const std::array<std::uint32_t, 3> v{m_mesh.indices[3 * t], m_mesh.indices[3 * t + 1],
                                                 m_mesh.indices[3 * t + 2]};
            split(v, {middleOf(v[0], v[1]), middleOf(v[1], v[2]), middleOf(v[2], v[0])}, made);
        }
        m_mesh.indices = std::move(made);
        return !m_middles.empty();
    }

    float unit(std::size_t vertex) const { return m_unit[vertex]; }

private:
    static constexpr std::uint32_t kWhole = 0xffffffffu;

    /// The vertex in the middle of an edge, kWhole for an edge that is short enough.
    std::uint32_t middleOf(std::uint32_t a, std::uint32_t b) {
        const float length_texels = glm::length((m_mesh.uvs[a] - m_mesh.uvs[b]) * m_texels);
        if (!(length_texels > kLongestEdge_texels) || !std::isfinite(length_texels)) return kWhole;
        const std::uint64_t edge = std::uint64_t(std::min(a, b)) << 32 | std::max(a, b);
        const auto [at, isNew] = m_middles.try_emplace(edge, std::uint32_t(m_mesh.positions.size()));
        if (isNew) addMiddle(a, b);
        return at->second;
    }

    void addMiddle(std::uint32_t a, std::uint32_t b) {
        m_mesh.positions.push_back((m_mesh.positions[a] + m_mesh.positions[b]) * 0.5f);
        const glm::vec3 n = m_mesh.normals[a] + m_mesh.normals[b];
        m_mesh.normals.push_back(glm::dot(n, n) > 0 ? glm::normalize(n) : glm::vec3(m_mesh.normals[a]));
        m_mesh.uvs.push_back((m_mesh.uvs[a] + m_mesh.uvs[b]) * 0.5f);
        if (!m_mesh.colors.empty()) m_mesh.colors.push_back((m_mesh.colors[a] + m_mesh.colors[b]) * 0.5f);
        m_unit.push_back((m_unit[a] + m_unit[b]) * 0.5f);
    }

    /// The triangles that a triangle with these middles becomes, wound as it is.
    static void split(const std::array<std::uint32_t, 3>& v, const std::array<std::uint32_t, 3>& middle,
                      std::vector<std::uint32_t>& made) {
        const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) { made.insert(made.end(), {a, b, c}); };
        int halved = 0;
        for (const std::uint32_t m : middle) halved += m != kWhole;
        if (halved == 0) return add(v[0], v[1], v[2]);
        if (halved == 3) {
            for (int k = 0; k < 3; ++k) add(v[k], middle[k], middle[(k + 2) % 3]);
            return add(middle[0], middle[1], middle[2]);
        }
        // Turned so that the first edge is halved, and of two the last one is not.
        int k = 0;
        while (middle[k] == kWhole || (halved == 2 && middle[(k + 2) % 3] != kWhole)) ++k;
        const std::uint32_t a = v[k], b = v[(k + 1) % 3], c = v[(k + 2) % 3], ab = middle[k], bc = middle[(k + 1) % 3];
        if (halved == 1) {
            add(a, ab, c);
            return add(ab, b, c);
        }
        add(ab, b, bc);
        add(a, ab, bc);
        add(a, bc, c);
    }

    Mesh& m_mesh;
    glm::vec2 m_texels;
    std::vector<float> m_unit;
    std::unordered_map<std::uint64_t, std::uint32_t> m_middles;
};

float meanHeight(const Texture& heights) {
    double sum = 0;
    for (std::size_t i = 0; i < heights.rgba.size(); i += 4) sum += heights.rgba[i];
    return float(sum / (255.0 * double(heights.rgba.size() / 4)));
}

/// Counts against a limit. @throws Error(Usage) above it.
class Budget {
public:
    Budget(const std::string& sceneName, std::size_t most) : m_sceneName(sceneName), m_most(most) {}

    void check(double triangles) const {
        if (triangles <= double(m_most)) return;
        throw Error(ErrorCode::Usage,
                    "the height maps of '" + m_sceneName + "' are too fine to be made geometry: they take more than " +
                        std::to_string(m_most) + " triangles",
                    "Use smaller height maps or repeat them less often.");
    }

private:
    const std::string& m_sceneName;
    std::size_t m_most;
};

void displace(Mesh& mesh, const Texture& heights, float scale_uv, const Budget& budget) {
    Division division(mesh, sizeOf(heights));
    while (division.halve()) budget.check(double(mesh.triangleCount()));
    const float mean = meanHeight(heights);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const float height = textureColor(heights, mesh.uvs[v]).r - mean;
        mesh.positions[v] += mesh.normals[v] * (height * scale_uv * division.unit(v));
    }
    mesh.normals.clear();
    mesh.tangents.clear();
    completeNormals(mesh);
    makeTangents(mesh);
}

}  // namespace

Scene displaced(const Scene& scene, std::size_t mostTriangles) {
    const Budget budget(scene.name, mostTriangles);
    Scene made = scene;
    const auto heightsOf = [&](const Mesh& mesh) -> const Texture* {
        const Material& material = scene.materials[std::size_t(mesh.material)];
        const bool has = material.heightTexture >= 0 && mesh.uvs.size() == mesh.positions.size();
        const Texture* heights = has ? &scene.textures[std::size_t(material.heightTexture)] : nullptr;
        return heights && !heights->rgba.empty() ? heights : nullptr;
    };
    // About two triangles a texel: told before the work.
    double triangles = 0;
    for (const Mesh& mesh : scene.meshes) {
        const Texture* heights = heightsOf(mesh);
        triangles += heights ? 2 * triangleTexels(mesh, *heights) : double(mesh.triangleCount());
    }
    budget.check(triangles);
    for (Mesh& mesh : made.meshes)
        if (const Texture* heights = heightsOf(mesh))
            displace(mesh, *heights, scene.materials[std::size_t(mesh.material)].heightScale_uv, budget);
    for (Material& material : made.materials)
        if (material.heightTexture >= 0) material.heightTexture = material.normalTexture = -1;
    return made;
}

}  // namespace ombrage
