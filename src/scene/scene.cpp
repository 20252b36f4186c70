// SPDX-License-Identifier: MIT
#include <cmath>

#include <ombrage/error.h>
#include <ombrage/scene.h>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace ombrage {

const char* lightTypeName(LightType type) {
    switch (type) {
        case LightType::Sun:
            return "sun";
        case LightType::Spot:
            return "spot";
        case LightType::Point:
            return "point";
        case LightType::Rect:
            return "rect";
    }
    return "";
}

bool Light::hasSize() const {
    switch (type) {
        case LightType::Sun:
            return angle_rad > 0.0f;
        case LightType::Spot:
        case LightType::Point:
            return radius_m > 0.0f;
        case LightType::Rect:
            return size_m.x > 0.0f || size_m.y > 0.0f;
    }
    return false;
}

glm::vec3 lightTangent(const Light& light) {
    const glm::vec3 axis = std::abs(light.direction.y) > 0.999f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    return glm::normalize(glm::cross(axis, light.direction));
}

glm::vec3 lightBitangent(const Light& light) {
    return glm::cross(light.direction, lightTangent(light));
}

Bounds Scene::bounds() const {
    Bounds result;
    for (const Instance& instance : instances) {
        const glm::dmat4& m = instance.worldFromLocal;
        for (const glm::vec3& p : meshes[std::size_t(instance.mesh)].positions) {
            const glm::dvec3 p_world(m * glm::dvec4(p, 1.0));
            if (!std::isfinite(p_world.x + p_world.y + p_world.z)) continue;
            result.lower = glm::min(result.lower, p_world);
            result.upper = glm::max(result.upper, p_world);
        }
    }
    return result;
}

std::size_t Scene::triangleCount() const {
    std::size_t count = 0;
    for (const Instance& instance : instances) count += meshes[std::size_t(instance.mesh)].triangleCount();
    return count;
}

namespace {
template <typename T>
int indexOfName(const std::vector<T>& all, const std::string& name, const char* kind) {
    if (name.empty() && !all.empty()) return 0;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].name == name) return int(i);
        names.push_back(all[i].name);
    }
    throw unknownName(kind, name, names);
}

/// A turn about the vertical axis through `center`.
glm::dmat4 turnAbout(const glm::dvec3& center, double angle_rad) {
    return glm::translate(glm::dmat4(1.0), center) * glm::rotate(glm::dmat4(1.0), angle_rad, glm::dvec3(0, 1, 0)) *
           glm::translate(glm::dmat4(1.0), -center);
}
}  // namespace

int Scene::cameraIndex(const std::string& cameraName) const {
    return indexOfName(cameras, cameraName, "camera");
}

int Scene::lightIndex(const std::string& lightName) const {
    return indexOfName(lights, lightName, "light");
}

void animate(Scene& scene, double time_s) {
    if (scene.animations.empty()) return;
    const Bounds bounds = scene.bounds();
    const glm::dvec3 center = bounds.empty() ? glm::dvec3(0.0) : bounds.center();
    for (const Animation& animation : scene.animations) {
        const double angle_rad = 2.0 * glm::pi<double>() * time_s / animation.period_s;
        const glm::dmat4 turn = turnAbout(center, angle_rad);
        if (animation.type == "orbit-camera") {
            for (Camera& camera : scene.cameras) {
                camera.position = glm::dvec3(turn * glm::dvec4(camera.position, 1.0));
                camera.target = glm::dvec3(turn * glm::dvec4(camera.target, 1.0));
                camera.up = glm::vec3(turn * glm::dvec4(camera.up, 0.0));
            }
        } else if (animation.type == "orbit-light") {
            Light& light = scene.lights[std::size_t(scene.lightIndex(animation.light))];
            light.position = glm::dvec3(turn * glm::dvec4(light.position, 1.0));
            light.direction = glm::vec3(glm::normalize(glm::dvec3(turn * glm::dvec4(light.direction, 0.0))));
        } else if (animation.type == "swing") {
            // The scene as loaded is the pose at time 0.
            const double start_rad = 2.0 * glm::pi<double>() * animation.phase;
            const double swing_rad = animation.amplitude_rad * (std::sin(angle_rad + start_rad) - std::sin(start_rad));
            const glm::dmat4 move = glm::translate(glm::dmat4(1.0), animation.pivot) *
                                    glm::rotate(glm::dmat4(1.0), swing_rad, animation.axis) *
                                    glm::translate(glm::dmat4(1.0), -animation.pivot);
            for (const int i : animation.instances) {
                Instance& instance = scene.instances[std::size_t(i)];
                instance.worldFromLocal = move * instance.worldFromLocal;
            }
        } else {
            throw unknownName("animation", animation.type, {"orbit-camera", "orbit-light", "swing"});
        }
    }
}

}  // namespace ombrage
