// SPDX-License-Identifier: MIT
#include "scene/scene_lights.h"

#include <algorithm>
#include <cmath>

#include "scene/framing.h"

namespace ombrage {

namespace {
constexpr double kFarthest_m = 1e9;
constexpr double kBrightest = 1e9;

LightType typeOf(const std::string& name) {
    for (const LightType type : {LightType::Spot, LightType::Point, LightType::Rect})
        if (name == lightTypeName(type)) return type;
    return LightType::Sun;
}

std::vector<std::string> keysOf(LightType type) {
    std::vector<std::string> keys = {"name", "type", "color", "intensity", "exclude"};
    const auto add = [&](std::initializer_list<const char*> more) {
        keys.insert(keys.end(), more.begin(), more.end());
    };
    switch (type) {
        case LightType::Sun:
            add({"direction", "angle_deg"});
            break;
        case LightType::Point:
            add({"position", "radius_m", "range_m"});
            break;
        case LightType::Spot:
            add({"position", "direction", "radius_m", "inner_deg", "outer_deg", "range_m"});
            break;
        case LightType::Rect:
            add({"position", "direction", "size_m", "range_m"});
            break;
    }
    return keys;
}

/// Where a light without a position hangs: above the centre, three quarters of the diagonal up.
glm::dvec3 defaultPosition(const Bounds& bounds) {
    return bounds.center() + glm::dvec3(0.0, 0.75 * bounds.diagonal(), 0.0);
}

/// As bright at the centre of the scene as the default sun.
float defaultIntensity(const Light& light, const Bounds& bounds) {
    const double sun_lx = double(defaultSun().intensity);
    if (light.type == LightType::Sun) return float(sun_lx);
    const glm::dvec3 arm = light.position - bounds.center();
    const double distance2 = std::max(glm::dot(arm, arm), 0.01);
    const double area = double(light.size_m.x) * double(light.size_m.y);
    return float(sun_lx * distance2 / (light.type == LightType::Rect ? area : 1.0));
}

void readCone(const JsonNode& node, Light& light) {
    const auto inner = node.find("inner_deg"), outer = node.find("outer_deg");
    if (outer) light.outer_rad = float(glm::radians(outer->numberAbove(0.0, 89.0)));
    if (inner)
        light.inner_rad = float(glm::radians(inner->number(0.0, 89.0)));
    else
        light.inner_rad = std::min(light.inner_rad, light.outer_rad);
    if (light.inner_rad > light.outer_rad)
        throw inner->error("the cone of full light is wider than the whole cone", "inner_deg may not exceed outer_deg");
}
}  // namespace

Light readLight(const JsonNode& node, const Scene& scene) {
    const std::string typeName = node.at("type").choice("light type", {"sun", "spot", "point", "rect"});
    Light light;
    light.type = typeOf(typeName);
    node.requireKeys("a " + typeName + " light", keysOf(light.type));
    const Bounds bounds = scene.bounds();

    light.position = defaultPosition(bounds);
    if (light.type == LightType::Sun) light.direction = defaultSun().direction;
    if (const auto position = node.find("position")) light.position = position->vec3(-kFarthest_m, kFarthest_m);
    if (const auto direction = node.find("direction")) light.direction = glm::vec3(direction->direction());
    if (const auto color = node.find("color")) light.color = glm::vec3(color->vec3(0.0, kBrightest));

    // The size.
    if (const auto radius = node.find("radius_m")) light.radius_m = float(radius->number(0.0, 1e6));
    if (const auto angle = node.find("angle_deg")) light.angle_rad = float(glm::radians(angle->number(0.0, 179.0)));
    if (const auto size = node.find("size_m")) {
        const std::vector<double> values = size->numbers(2, 0.0, 1e6);
        light.size_m = glm::vec2(float(values[0]), float(values[1]));
    }
    if (light.type == LightType::Rect && !(light.size_m.x > 0 && light.size_m.y > 0))
        throw node.error("a rect light without an area gives no light", "give size_m, its width and height in metres");
    if (light.type == LightType::Spot) readCone(node, light);
    if (const auto range = node.find("range_m")) light.range_m = float(range->numberAbove(0.0, kFarthest_m));

    light.intensity = defaultIntensity(light, bounds);
    if (const auto intensity = node.find("intensity")) light.intensity = float(intensity->number(0.0, kBrightest));
    if (const auto exclude = node.find("exclude")) {
        std::vector<std::string> names;
        for (const Model& model : scene.models) names.push_back(model.name);
        for (const JsonNode& model : exclude->elements()) {
            const std::string name = model.choice("model", names);
            light.excludedModels.push_back(int(std::find(names.begin(), names.end(), name) - names.begin()));
        }
    }
    return light;
}

}  // namespace ombrage
