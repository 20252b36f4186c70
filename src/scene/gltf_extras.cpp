// SPDX-License-Identifier: MIT
#include "scene/gltf_extras.h"

#include <cstring>
#include <optional>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <nlohmann/json.hpp>

namespace ombrage {

namespace {
using nlohmann::json;

constexpr int kDeepestNode = 256;

/// The JSON text: the file itself, or the first chunk behind a GLB's 12 byte head.
std::string jsonPart(const std::string& content) {
    if (content.compare(0, 4, "glTF") != 0) return content;
    if (content.size() < 20) return {};
    std::uint32_t length = 0;
    std::memcpy(&length, content.data() + 12, 4);
    return content.substr(20, length);
}

/// A member of an object, or null; never throws.
const json& member(const json& object, const char* key) {
    static const json nothing;
    if (!object.is_object()) return nothing;
    const auto found = object.find(key);
    return found == object.end() ? nothing : *found;
}

double numberOr(const json& value, double otherwise) {
    return value.is_number() ? value.get<double>() : otherwise;
}

std::string textOr(const json& value, const std::string& otherwise) {
    return value.is_string() ? value.get<std::string>() : otherwise;
}

/// An index into an array, or -1.
int indexInto(const json& value, const json& array) {
    if (!value.is_number_integer() || !array.is_array()) return -1;
    const auto index = value.get<std::int64_t>();
    return index >= 0 && index < std::int64_t(array.size()) ? int(index) : -1;
}

template <int N>
glm::vec<N, double, glm::defaultp> vectorOr(const json& value, glm::vec<N, double, glm::defaultp> otherwise) {
    if (!value.is_array() || value.size() != N) return otherwise;
    for (int i = 0; i < N; ++i) otherwise[i] = numberOr(value[std::size_t(i)], otherwise[i]);
    return otherwise;
}

glm::dmat4 localTransform(const json& node) {
    const json& matrix = member(node, "matrix");
    if (matrix.is_array() && matrix.size() == 16) {
        glm::dmat4 m(1.0);
        for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = numberOr(matrix[std::size_t(i)], m[i / 4][i % 4]);
        return m;
    }
    const glm::dvec4 q = vectorOr<4>(member(node, "rotation"), {0, 0, 0, 1});
    return glm::translate(glm::dmat4(1.0), vectorOr<3>(member(node, "translation"), glm::dvec3(0.0))) *
           glm::mat4_cast(glm::dquat(q.w, q.x, q.y, q.z)) *
           glm::scale(glm::dmat4(1.0), vectorOr<3>(member(node, "scale"), glm::dvec3(1.0)));
}

std::optional<Light> toLight(const json& source, const glm::dmat4& worldFromNode) {
    const std::string type = textOr(member(source, "type"), "");
    Light light;
    if (type == "directional")
        light.type = LightType::Sun;
    else if (type == "point")
        light.type = LightType::Point;
    else if (type == "spot")
        light.type = LightType::Spot;
    else
        return std::nullopt;
    light.name = textOr(member(source, "name"), lightTypeName(light.type));
    light.position = glm::dvec3(worldFromNode[3]);
    // Lights shine along -z of their node.
    const glm::dvec3 direction = -glm::dvec3(worldFromNode[2]);
    if (!(glm::length(direction) > 1e-12)) return std::nullopt;
    light.direction = glm::vec3(glm::normalize(direction));
    light.color = glm::vec3(vectorOr<3>(member(source, "color"), glm::dvec3(1.0)));
    light.intensity = float(numberOr(member(source, "intensity"), 1.0));
    const double range_m = numberOr(member(source, "range"), 0.0);
    if (light.type != LightType::Sun && range_m > 0.0) light.range_m = float(range_m);
    if (light.type == LightType::Spot) {
        light.inner_rad = float(numberOr(member(member(source, "spot"), "innerConeAngle"), 0.0));
        light.outer_rad = float(numberOr(member(member(source, "spot"), "outerConeAngle"), 0.7853981633974483));
    }
    return light;
}

std::optional<Camera> toCamera(const json& source, const glm::dmat4& worldFromNode, int number) {
    Camera camera;
    camera.name = textOr(member(source, "name"), "camera-" + std::to_string(number));
    camera.position = glm::dvec3(worldFromNode[3]);
    const glm::dvec3 forward = -glm::dvec3(worldFromNode[2]), up(worldFromNode[1]);
    if (!(glm::length(forward) > 1e-12) || !(glm::length(up) > 1e-12)) return std::nullopt;
    camera.target = camera.position + glm::normalize(forward);
    camera.up = glm::vec3(glm::normalize(up));
    if (textOr(member(source, "type"), "") == "orthographic") {
        const double halfHeight_m = numberOr(member(member(source, "orthographic"), "ymag"), 0.0);
        if (!(halfHeight_m > 0.0)) return std::nullopt;
        camera.orthoHeight_m = float(2.0 * halfHeight_m);
    } else {
        const double fov_rad = numberOr(member(member(source, "perspective"), "yfov"), 0.0);
        if (!(fov_rad > 0.0) || !(fov_rad < 3.1)) return std::nullopt;
        camera.fovY_rad = float(fov_rad);
    }
    return camera;
}

class Walker {
public:
    Walker(const json& root, GltfExtras& extras)
        : m_nodes(member(root, "nodes")),
          m_lights(member(member(member(root, "extensions"), "KHR_lights_punctual"), "lights")),
          m_cameras(member(root, "cameras")),
          m_extras(extras),
          m_visited(m_nodes.is_array() ? m_nodes.size() : 0, false) {}

    void visit(const json& nodeIndex, const glm::dmat4& worldFromParent, int depth) {
        const int index = indexInto(nodeIndex, m_nodes);
        // A node has one parent; whoever comes again is part of a cycle or of a broken tree.
        if (index < 0 || depth > kDeepestNode || m_visited[std::size_t(index)]) return;
        m_visited[std::size_t(index)] = true;
        const json& node = m_nodes[std::size_t(index)];
        const glm::dmat4 worldFromNode = worldFromParent * localTransform(node);

        const int light =
            indexInto(member(member(member(node, "extensions"), "KHR_lights_punctual"), "light"), m_lights);
        if (light >= 0) {
            if (auto made = toLight(m_lights[std::size_t(light)], worldFromNode))
                m_extras.lights.push_back(*made);
            else
                m_extras.warnings.push_back("light " + std::to_string(light) +
                                            " of the file is left out: it is not as KHR_lights_punctual wants it");
        }
        const int camera = indexInto(member(node, "camera"), m_cameras);
        if (camera >= 0) {
            if (auto made = toCamera(m_cameras[std::size_t(camera)], worldFromNode, camera))
                m_extras.cameras.push_back(*made);
            else
                m_extras.warnings.push_back("camera " + std::to_string(camera) +
                                            " of the file is left out: it has no usable projection");
        }
        const json& children = member(node, "children");
        if (children.is_array())
            for (const json& child : children) visit(child, worldFromNode, depth + 1);
    }

private:
    const json& m_nodes;
    const json& m_lights;
    const json& m_cameras;
    GltfExtras& m_extras;
    std::vector<bool> m_visited;
};

GltfUv uvOf(const json& texture) {
    GltfUv uv;
    const json& transform = member(member(texture, "extensions"), "KHR_texture_transform");
    uv.set = int(numberOr(member(texture, "texCoord"), 0.0));
    uv.set = int(numberOr(member(transform, "texCoord"), uv.set));
    uv.offset = glm::vec2(vectorOr<2>(member(transform, "offset"), glm::dvec2(0.0)));
    uv.scale = glm::vec2(vectorOr<2>(member(transform, "scale"), glm::dvec2(1.0)));
    uv.rotation_rad = float(numberOr(member(transform, "rotation"), 0.0));
    return uv;
}

GltfUv materialUv(const json& material, std::vector<std::string>& warnings) {
    const json& pbr = member(material, "pbrMetallicRoughness");
    std::optional<GltfUv> first;
    bool differ = false;
    for (const json* texture : {&member(pbr, "baseColorTexture"), &member(pbr, "metallicRoughnessTexture"),
                                &member(material, "normalTexture"), &member(material, "emissiveTexture")}) {
        if (!texture->is_object()) continue;
        const GltfUv uv = uvOf(*texture);
        differ = differ || (first && *first != uv);
        if (!first) first = uv;
    }
    if (differ)
        warnings.push_back("material '" + textOr(member(material, "name"), "") +
                           "' places its textures differently; all are placed as the first");
    return first.value_or(GltfUv{});
}
}  // namespace

glm::vec2 GltfUv::apply(const glm::vec2& uv) const {
    // KHR_texture_transform: offset * rotation * scale, turning counter-clockwise with v downwards.
    const glm::vec2 s = uv * scale;
    const float c = std::cos(rotation_rad), n = std::sin(rotation_rad);
    return offset + glm::vec2(c * s.x + n * s.y, c * s.y - n * s.x);
}

GltfExtras readGltfExtras(const std::string& content) {
    GltfExtras extras;
    const json root = json::parse(jsonPart(content), nullptr, false);
    if (!root.is_object()) return extras;
    const json& materials = member(root, "materials");
    if (materials.is_array())
        for (const json& material : materials) extras.materialUvs.push_back(materialUv(material, extras.warnings));

    // Walk the scene that the file shows.
    const json& scenes = member(root, "scenes");
    const int shown = indexInto(root.value("scene", json(0)), scenes);
    if (shown < 0) return extras;
    Walker walker(root, extras);
    const json& roots = member(scenes[std::size_t(shown)], "nodes");
    if (roots.is_array())
        for (const json& node : roots) walker.visit(node, glm::dmat4(1.0), 0);
    const json& skins = member(root, "skins");
    if (skins.is_array() && !skins.empty()) extras.warnings.push_back("skinned meshes stand in their rest pose");
    return extras;
}

}  // namespace ombrage
