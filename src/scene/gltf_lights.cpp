// SPDX-License-Identifier: MIT
#include "scene/gltf_lights.h"

#include <optional>

namespace ombrage {

namespace {
std::optional<Light> toLight(const GltfJson& source, const glm::dmat4& worldFromNode) {
    const std::string type = gltfText(gltfMember(source, "type"), "");
    Light light;
    if (type == "directional")
        light.type = LightType::Sun;
    else if (type == "point")
        light.type = LightType::Point;
    else if (type == "spot")
        light.type = LightType::Spot;
    else
        return std::nullopt;
    light.name = gltfText(gltfMember(source, "name"), lightTypeName(light.type));
    light.position = glm::dvec3(worldFromNode[3]);
    // Lights shine along -z of their node.
    const glm::dvec3 direction = -glm::dvec3(worldFromNode[2]);
    if (!(glm::length(direction) > 1e-12)) return std::nullopt;
    light.direction = glm::vec3(glm::normalize(direction));
    light.color = glm::vec3(gltfVector<3>(gltfMember(source, "color"), glm::dvec3(1.0)));
    light.intensity = float(gltfNumber(gltfMember(source, "intensity"), 1.0));
    const double range_m = gltfNumber(gltfMember(source, "range"), 0.0);
    if (light.type != LightType::Sun && range_m > 0.0) light.range_m = float(range_m);
    if (light.type == LightType::Spot) {
        light.inner_rad = float(gltfNumber(gltfMember(gltfMember(source, "spot"), "innerConeAngle"), 0.0));
        light.outer_rad =
            float(gltfNumber(gltfMember(gltfMember(source, "spot"), "outerConeAngle"), 0.7853981633974483));
    }
    return light;
}

std::optional<Camera> toCamera(const GltfJson& source, const glm::dmat4& worldFromNode, int number) {
    Camera camera;
    camera.name = gltfText(gltfMember(source, "name"), "camera-" + std::to_string(number));
    camera.position = glm::dvec3(worldFromNode[3]);
    const glm::dvec3 forward = -glm::dvec3(worldFromNode[2]), up(worldFromNode[1]);
    if (!(glm::length(forward) > 1e-12) || !(glm::length(up) > 1e-12)) return std::nullopt;
    camera.target = camera.position + glm::normalize(forward);
    camera.up = glm::vec3(glm::normalize(up));
    if (gltfText(gltfMember(source, "type"), "") == "orthographic") {
        const double halfHeight_m = gltfNumber(gltfMember(gltfMember(source, "orthographic"), "ymag"), 0.0);
        if (!(halfHeight_m > 0.0)) return std::nullopt;
        camera.orthoHeight_m = float(2.0 * halfHeight_m);
    } else {
        const double fov_rad = gltfNumber(gltfMember(gltfMember(source, "perspective"), "yfov"), 0.0);
        if (!(fov_rad > 0.0) || !(fov_rad < 3.1)) return std::nullopt;
        camera.fovY_rad = float(fov_rad);
    }
    return camera;
}
}  // namespace

void readGltfLights(const GltfDocument& document, const std::vector<GltfNode>& nodes, ModelFile& model) {
    const GltfJson& root = document.root();
    const GltfJson& lights = gltfMember(gltfMember(gltfMember(root, "extensions"), "KHR_lights_punctual"), "lights");
    const GltfJson& cameras = gltfMember(root, "cameras");
    for (const GltfNode& placed : nodes) {
        const GltfJson& node = root["nodes"][placed.index];
        const int light =
            gltfIndex(gltfMember(gltfMember(gltfMember(node, "extensions"), "KHR_lights_punctual"), "light"), lights);
        if (light >= 0) {
            if (auto made = toLight(lights[std::size_t(light)], placed.worldFromNode))
                model.lights.push_back(*made);
            else
                model.warnings.push_back("light " + std::to_string(light) +
                                         " of the file is left out: it is not as KHR_lights_punctual wants it");
        }
        const int camera = gltfIndex(gltfMember(node, "camera"), cameras);
        if (camera < 0) continue;
        if (auto made = toCamera(cameras[std::size_t(camera)], placed.worldFromNode, camera))
            model.cameras.push_back(*made);
        else
            model.warnings.push_back("camera " + std::to_string(camera) +
                                     " of the file is left out: it has no usable projection");
    }
}

}  // namespace ombrage
