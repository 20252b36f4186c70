// SPDX-License-Identifier: MIT
#include "scene/gltf_nodes.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

namespace ombrage {

namespace {
constexpr int kDeepestNode = 256;

glm::dmat4 localTransform(const GltfJson& node) {
    const GltfJson& matrix = gltfMember(node, "matrix");
    if (matrix.is_array() && matrix.size() == 16) {
        glm::dmat4 m(1.0);
        for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = gltfNumber(matrix[std::size_t(i)], m[i / 4][i % 4]);
        return m;
    }
    const glm::dvec4 q = gltfVector<4>(gltfMember(node, "rotation"), {0, 0, 0, 1});
    return glm::translate(glm::dmat4(1.0), gltfVector<3>(gltfMember(node, "translation"), glm::dvec3(0.0))) *
           glm::mat4_cast(glm::dquat(q.w, q.x, q.y, q.z)) *
           glm::scale(glm::dmat4(1.0), gltfVector<3>(gltfMember(node, "scale"), glm::dvec3(1.0)));
}

class Walker {
public:
    explicit Walker(const GltfDocument& document)
        : m_document(document), m_nodes(gltfMember(document.root(), "nodes")), m_visited(m_nodes.size(), false) {}

    void visit(const GltfJson& nodeIndex, const glm::dmat4& worldFromParent, int depth, const std::string& place) {
        const std::size_t index = m_document.find("nodes", nodeIndex, place);
        const std::string here = "/nodes/" + std::to_string(index);
        if (m_visited[index])
            m_document.fail(place, "node " + std::to_string(index) + " has two parents, or is its own");
        if (depth > kDeepestNode) m_document.fail(here, "nodes stand more than 256 deep in one another");
        m_visited[index] = true;
        const GltfJson& node = m_nodes[index];
        const glm::dmat4 worldFromNode = worldFromParent * localTransform(node);
        m_placed.push_back({index, worldFromNode});
        const GltfJson& children = gltfMember(node, "children");
        for (std::size_t i = 0; children.is_array() && i < children.size(); ++i)
            visit(children[i], worldFromNode, depth + 1, here + "/children/" + std::to_string(i));
    }

    std::vector<GltfNode> take() { return std::move(m_placed); }

private:
    const GltfDocument& m_document;
    const GltfJson& m_nodes;
    std::vector<bool> m_visited;
    std::vector<GltfNode> m_placed;
};

/// Every node that is nobody's child.
GltfJson rootsOf(const GltfJson& nodes) {
    std::vector<bool> isChild(nodes.size(), false);
    for (const GltfJson& node : nodes) {
        const GltfJson& children = gltfMember(node, "children");
        for (std::size_t i = 0; children.is_array() && i < children.size(); ++i)
            if (const int child = gltfIndex(children[i], nodes); child >= 0) isChild[std::size_t(child)] = true;
    }
    GltfJson roots = GltfJson::array();
    for (std::size_t i = 0; i < isChild.size(); ++i)
        if (!isChild[i]) roots.push_back(i);
    return roots;
}
}  // namespace

std::vector<GltfNode> placedNodes(const GltfDocument& document) {
    const GltfJson& root = document.root();
    const GltfJson& nodes = gltfMember(root, "nodes");
    if (!nodes.is_array()) return {};
    const GltfJson& scenes = gltfMember(root, "scenes");
    GltfJson roots;
    std::string place = "/nodes";
    if (scenes.is_array() && !scenes.empty()) {
        const std::size_t shown =
            document.find("scenes", root.contains("scene") ? root["scene"] : GltfJson(0), "/scene");
        roots = gltfMember(scenes[shown], "nodes");
        place = "/scenes/" + std::to_string(shown) + "/nodes";
    } else {
        roots = rootsOf(nodes);
    }
    Walker walker(document);
    for (std::size_t i = 0; roots.is_array() && i < roots.size(); ++i)
        walker.visit(roots[i], glm::dmat4(1.0), 0, place + "/" + std::to_string(i));
    return walker.take();
}

}  // namespace ombrage
