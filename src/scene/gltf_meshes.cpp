// SPDX-License-Identifier: MIT
#include "scene/gltf_meshes.h"

#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>

namespace ombrage {

namespace {
/// Vertices of all primitives: small files that use one accessor again and again cannot fill the memory.
constexpr int kMostVertices = 1 << 25;

constexpr int kTriangles = 4, kStrip = 5, kFan = 6;

template <typename V>
std::vector<V> toVectors(const GltfDocument::Values& values) {
    std::vector<V> out(values.count);
    for (std::size_t i = 0; i < values.count; ++i)
        for (int c = 0; c < V::length(); ++c) out[i][c] = values.numbers[i * std::size_t(V::length()) + std::size_t(c)];
    return out;
}

/// Matrices of a skin's joints as the file poses them: world from the bind pose.
struct Skin {
    std::vector<glm::dmat4> worldFromBind;
};

class MeshReader {
public:
    MeshReader(GltfDocument& document, const std::vector<GltfNode>& nodes, const std::vector<GltfUv>& materialUvs,
               ModelFile& model)
        : m_document(document), m_nodes(nodes), m_materialUvs(materialUvs), m_model(model) {}

    void read() {
        for (const GltfNode& placed : m_nodes) {
            const GltfJson& node = m_document.root()["nodes"][placed.index];
            const GltfJson& mesh = gltfMember(node, "mesh");
            if (mesh.is_null()) continue;
            const std::string place = "/nodes/" + std::to_string(placed.index);
            const std::size_t number = m_document.find("meshes", mesh, place + "/mesh");
            const GltfJson &skin = gltfMember(node, "skin"), &weights = gltfMember(node, "weights");
            if (skin.is_null() && weights.is_null()) {
                for (const int made : sharedMeshes(number)) m_model.parts.push_back({made, placed.worldFromNode});
            } else {
                // A skin moves the vertices of this one node, and its own transform does not count.
                std::optional<Skin> pose;
                if (!skin.is_null()) pose = readSkin(m_document.find("skins", skin, place + "/skin"));
                for (const int made : readMesh(number, weights, pose ? &*pose : nullptr))
                    m_model.parts.push_back({made, pose ? glm::dmat4(1.0) : placed.worldFromNode});
            }
        }
        if (m_model.parts.empty() && m_leftOut == 0) readUnplaced();
        if (m_leftOut > 0)
            m_model.warnings.push_back(std::to_string(m_leftOut) + " primitives of points or lines are left out");
        if (m_colorAlpha) m_model.warnings.push_back("the opacity of vertex colours is not used");
    }

private:
    /// A file whose scene shows no mesh is a collection of meshes.
    void readUnplaced() {
        const GltfJson& meshes = gltfMember(m_document.root(), "meshes");
        if (!meshes.is_array() || meshes.empty()) m_document.fail("/meshes", "the file has no meshes");
        m_model.warnings.push_back("no node of the file's scene shows a mesh; all meshes stand at the origin");
        for (std::size_t i = 0; i < meshes.size(); ++i)
            for (const int made : sharedMeshes(i)) m_model.parts.push_back({made, glm::dmat4(1.0)});
    }

    const std::vector<int>& sharedMeshes(std::size_t number) {
        const auto found = m_shared.find(number);
        if (found != m_shared.end()) return found->second;
        return m_shared.emplace(number, readMesh(number, GltfJson(), nullptr)).first->second;
    }

    std::vector<int> readMesh(std::size_t number, const GltfJson& nodeWeights, const Skin* skin) {
        const std::string place = "/meshes/" + std::to_string(number);
        const GltfJson& json = m_document.root()["meshes"][number];
        const GltfJson& primitives = gltfMember(json, "primitives");
        if (!primitives.is_array() || primitives.empty()) m_document.fail(place + "/primitives", "the mesh has none");
        const GltfJson& weights = nodeWeights.is_array() ? nodeWeights : gltfMember(json, "weights");
        // Before any is read: many primitives may share one accessor, and each makes its vertices anew.
        for (std::size_t i = 0; i < primitives.size(); ++i) {
            m_statedVertices += statedVertices(primitives[i]);
            if (m_statedVertices > kMostVertices)
                m_document.fail(place + "/primitives/" + std::to_string(i),
                                fmt::format("the file's primitives have over {} vertices", kMostVertices));
        }
        std::vector<int> made;
        for (std::size_t i = 0; i < primitives.size(); ++i) {
            const std::string here = place + "/primitives/" + std::to_string(i);
            const double mode = gltfNumber(gltfMember(primitives[i], "mode"), kTriangles);
            if (mode >= 0.0 && mode < kTriangles) {
                ++m_leftOut;
                continue;
            }
            if (mode != kTriangles && mode != kStrip && mode != kFan)
                m_document.fail(here + "/mode", "it is none of 0 to 6");
            Mesh mesh = readPrimitive(primitives[i], int(mode), weights, skin, here);
            mesh.name = gltfText(gltfMember(json, "name"), "mesh " + std::to_string(number));
            made.push_back(int(m_model.meshes.size()));
            m_model.meshes.push_back(std::move(mesh));
        }
        return made;
    }

    /// What the accessor of the positions says of itself; 0 where it is not as it should be, which reading it will
    /// find.
    double statedVertices(const GltfJson& primitive) const {
        const double number = gltfNumber(gltfMember(gltfMember(primitive, "attributes"), "POSITION"), -1.0);
        const GltfJson& accessors = gltfMember(m_document.root(), "accessors");
        if (!accessors.is_array() || !(number >= 0.0 && number < double(accessors.size()))) return 0.0;
        const double count = gltfNumber(gltfMember(accessors[std::size_t(number)], "count"), 0.0);
        return count >= 0.0 && count <= kMostVertices ? count : 0.0;
    }

    Mesh readPrimitive(const GltfJson& json, int mode, const GltfJson& weights, const Skin* skin,
                       const std::string& place) {
        Mesh mesh;
        const GltfJson& attributes = gltfMember(json, "attributes");
        if (gltfMember(attributes, "POSITION").is_null())
            m_document.fail(place + "/attributes", "a primitive without POSITION",
                            "compressed meshes are not read: export without compression");
        const GltfJson& material = gltfMember(json, "material");
        mesh.material = -1;
        if (!material.is_null()) mesh.material = int(m_document.find("materials", material, place + "/material"));

        const auto attribute = [&](const char* name, int components, const GltfJson& of) {
            const std::string here = place + "/attributes/" + name;
            auto values = m_document.values(gltfMember(of, name), components, here);
            if (!mesh.positions.empty() && values.count != mesh.positions.size())
                m_document.fail(here, fmt::format("{} values for {} positions", values.count, mesh.positions.size()));
            return values;
        };
        const auto has = [&](const char* name) { return !gltfMember(attributes, name).is_null(); };
        mesh.positions = toVectors<glm::vec3>(attribute("POSITION", 3, attributes));
        if (has("NORMAL")) mesh.normals = toVectors<glm::vec3>(attribute("NORMAL", 3, attributes));
        if (has("NORMAL") && has("TANGENT")) mesh.tangents = toVectors<glm::vec4>(attribute("TANGENT", 4, attributes));
        readUvs(mesh, attributes, attribute);
        if (has("COLOR_0")) readColors(mesh, attribute("COLOR_0", 0, attributes), place);
        readIndices(mesh, gltfMember(json, "indices"), mode, place);

        const GltfJson& targets = gltfMember(json, "targets");
        for (std::size_t t = 0; targets.is_array() && weights.is_array() && t < targets.size() && t < weights.size();
             ++t)
            if (const auto weight = float(gltfNumber(weights[t], 0.0)); weight != 0.0f)
                morph(mesh, targets[t], weight, attribute);
        if (skin != nullptr && has("JOINTS_0") && has("WEIGHTS_0"))
            bend(mesh, *skin, attribute("JOINTS_0", 4, attributes), attribute("WEIGHTS_0", 4, attributes), place);
        return mesh;
    }

    template <typename Attribute>
    void readUvs(Mesh& mesh, const GltfJson& attributes, const Attribute& attribute) const {
        const bool known = mesh.material >= 0 && std::size_t(mesh.material) < m_materialUvs.size();
        const GltfUv uv = known ? m_materialUvs[std::size_t(mesh.material)] : GltfUv{};
        std::string name = "TEXCOORD_" + std::to_string(uv.set);
        if (gltfMember(attributes, name.c_str()).is_null()) name = "TEXCOORD_0";
        if (gltfMember(attributes, name.c_str()).is_null()) return;
        mesh.uvs = toVectors<glm::vec2>(attribute(name.c_str(), 2, attributes));
        for (glm::vec2& at : mesh.uvs) {
            if (!uv.isIdentity()) at = uv.apply(at);
            if (!std::isfinite(at.x) || !std::isfinite(at.y)) at = glm::vec2(0.0f);
        }
    }

    void readColors(Mesh& mesh, const GltfDocument::Values& values, const std::string& place) {
        if (values.components != 3 && values.components != 4)
            m_document.fail(place + "/attributes/COLOR_0", "colours have 3 or 4 components");
        const auto components = std::size_t(values.components);
        bool allWhite = true;
        for (std::size_t i = 0; i < values.count; ++i) {
            const float* c = &values.numbers[i * components];
            mesh.colors.emplace_back(c[0], c[1], c[2]);
            allWhite = allWhite && mesh.colors.back() == glm::vec3(1.0f);
            m_colorAlpha = m_colorAlpha || (components == 4 && c[3] != 1.0f);
        }
        if (allWhite) mesh.colors.clear();
    }

    void readIndices(Mesh& mesh, const GltfJson& accessor, int mode, const std::string& place) {
        std::vector<std::uint32_t> order;
        if (accessor.is_null()) {
            for (std::size_t i = 0; i < mesh.positions.size(); ++i) order.push_back(std::uint32_t(i));
        } else {
            order = m_document.indices(accessor, place + "/indices");
        }
        for (std::size_t i = 0; i < order.size(); ++i)
            if (order[i] >= mesh.positions.size())
                m_document.fail(place + "/indices", fmt::format("index {} at {} is not below the {} vertices", order[i],
                                                                i, mesh.positions.size()));
        if (mode == kTriangles) {
            order.resize(order.size() / 3 * 3);
            mesh.indices = std::move(order);
            return;
        }
        for (std::size_t i = 2; i < order.size(); ++i) {
            const std::uint32_t first = mode == kFan ? order[0] : order[i % 2 == 0 ? i - 2 : i - 1];
            const std::uint32_t second = mode == kFan ? order[i - 1] : order[i % 2 == 0 ? i - 1 : i - 2];
            // Strips are stitched together by triangles of two corners.
            if (first != second && second != order[i] && first != order[i])
                mesh.indices.insert(mesh.indices.end(), {first, second, order[i]});
        }
    }

    template <typename Attribute>
    static void morph(Mesh& mesh, const GltfJson& target, float weight, const Attribute& attribute) {
        if (!gltfMember(target, "POSITION").is_null()) {
            const auto moves = toVectors<glm::vec3>(attribute("POSITION", 3, target));
            for (std::size_t i = 0; i < moves.size(); ++i) mesh.positions[i] += weight * moves[i];
        }
        if (!mesh.normals.empty() && !gltfMember(target, "NORMAL").is_null()) {
            const auto moves = toVectors<glm::vec3>(attribute("NORMAL", 3, target));
            for (std::size_t i = 0; i < moves.size(); ++i) mesh.normals[i] += weight * moves[i];
        }
    }

    Skin readSkin(std::size_t number) {
        const std::string place = "/skins/" + std::to_string(number);
        const GltfJson& json = m_document.root()["skins"][number];
        const GltfJson& joints = gltfMember(json, "joints");
        if (!joints.is_array() || joints.empty()) m_document.fail(place + "/joints", "the skin has none");
        GltfDocument::Values binds;
        if (const GltfJson& accessor = gltfMember(json, "inverseBindMatrices"); !accessor.is_null()) {
            binds = m_document.values(accessor, 16, place + "/inverseBindMatrices");
            if (binds.count < joints.size())
                m_document.fail(place + "/inverseBindMatrices",
                                fmt::format("{} matrices for {} joints", binds.count, joints.size()));
        }
        Skin skin;
        for (std::size_t i = 0; i < joints.size(); ++i) {
            const std::size_t node = m_document.find("nodes", joints[i], place + "/joints/" + std::to_string(i));
            glm::dmat4 bind(1.0);
            for (int k = 0; k < 16 && binds.count > 0; ++k)
                bind[k / 4][k % 4] = double(binds.numbers[i * 16 + std::size_t(k)]);
            skin.worldFromBind.push_back(worldOf(node, place) * bind);
        }
        return skin;
    }

    const glm::dmat4& worldOf(std::size_t node, const std::string& place) {
        if (m_worldOf.empty())
            for (const GltfNode& placed : m_nodes) m_worldOf.emplace(placed.index, placed.worldFromNode);
        const auto found = m_worldOf.find(node);
        if (found == m_worldOf.end())
            m_document.fail(place, "joint node " + std::to_string(node) + " does not stand in the scene");
        return found->second;
    }

    /// Linear blend skinning: every vertex by the mean of its joints' matrices, weighted.
    void bend(Mesh& mesh, const Skin& skin, const GltfDocument::Values& joints, const GltfDocument::Values& weights,
              const std::string& place) const {
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            glm::dmat4 m(0.0);
            double sum = 0.0;
            for (std::size_t k = 4 * v; k < 4 * v + 4; ++k) {
                const double weight = double(weights.numbers[k]);
                if (!(weight > 0.0)) continue;
                const double joint = double(joints.numbers[k]);
                if (!(joint >= 0.0) || joint >= double(skin.worldFromBind.size()))
                    m_document.fail(place + "/attributes/JOINTS_0",
                                    fmt::format("vertex {}: joint {} of {}", v, joint, skin.worldFromBind.size()));
                m += weight * skin.worldFromBind[std::size_t(joint)];
                sum += weight;
            }
            if (!(sum > 0.0)) continue;
            m /= sum;
            mesh.positions[v] = glm::vec3(m * glm::dvec4(mesh.positions[v], 1.0));
            const glm::dmat3 linear(m);
            const double volume = glm::determinant(linear);
            if (!mesh.normals.empty() && volume != 0.0)
                mesh.normals[v] = glm::vec3(glm::transpose(glm::inverse(linear)) * glm::dvec3(mesh.normals[v]));
            if (!mesh.tangents.empty())
                mesh.tangents[v] = glm::vec4(glm::vec3(linear * glm::dvec3(mesh.tangents[v])), mesh.tangents[v].w);
        }
    }

    GltfDocument& m_document;
    const std::vector<GltfNode>& m_nodes;
    const std::vector<GltfUv>& m_materialUvs;
    ModelFile& m_model;
    std::map<std::size_t, std::vector<int>> m_shared;  ///< meshes of the model by mesh of the file
    std::map<std::size_t, glm::dmat4> m_worldOf;
    double m_statedVertices = 0;  ///< of the primitives read so far and of those about to be
    std::size_t m_leftOut = 0;
    bool m_colorAlpha = false;
};
}  // namespace

void readGltfMeshes(GltfDocument& document, const std::vector<GltfNode>& nodes, const std::vector<GltfUv>& materialUvs,
                    ModelFile& model) {
    MeshReader(document, nodes, materialUvs, model).read();
}

}  // namespace ombrage
