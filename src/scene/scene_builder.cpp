// SPDX-License-Identifier: MIT
#include "scene/scene_builder.h"

#include <cmath>
#include <utility>

#include <ombrage/image.h>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/mesh_build.h"

namespace ombrage {

SceneBuilder::SceneBuilder(std::string name) {
    m_scene.name = std::move(name);
}

Material paint(const glm::vec3& color_srgb) {
    Material material;
    for (int i = 0; i < 3; ++i) material.baseColor[i] = linearFromSrgb(color_srgb[i]);
    return material;
}

void SceneBuilder::place(const std::string& name, Mesh mesh, Material material, const glm::dmat4& worldFromLocal) {
    material.name = name;
    m_scene.materials.push_back(std::move(material));
    mesh.name = name;
    mesh.material = int(m_scene.materials.size()) - 1;
    makeTangents(mesh);
    m_scene.meshes.push_back(std::move(mesh));
    m_scene.instances.push_back({int(m_scene.meshes.size()) - 1, int(m_scene.models.size()) - 1, worldFromLocal});
}

SceneBuilder& SceneBuilder::object(const std::string& name, Mesh mesh, const glm::vec3& color_srgb,
                                   const glm::dvec3& position, double turn_deg) {
    return object(name, std::move(mesh), paint(color_srgb),
                  glm::rotate(glm::translate(glm::dmat4(1.0), position), glm::radians(turn_deg), glm::dvec3(0, 1, 0)));
}

SceneBuilder& SceneBuilder::object(const std::string& name, Mesh mesh, Material material,
                                   const glm::dmat4& worldFromLocal) {
    m_scene.models.push_back({.name = name});
    place(name, std::move(mesh), std::move(material), worldFromLocal);
    return *this;
}

SceneBuilder& SceneBuilder::part(const std::string& name, Mesh mesh, const glm::vec3& color_srgb,
                                 const glm::dmat4& worldFromLocal) {
    place(name, std::move(mesh), paint(color_srgb), worldFromLocal);
    return *this;
}

SceneBuilder& SceneBuilder::again(const std::string& name, const glm::dmat4& worldFromLocal) {
    m_scene.models.push_back({.name = name});
    m_scene.instances.push_back({int(m_scene.meshes.size()) - 1, int(m_scene.models.size()) - 1, worldFromLocal});
    return *this;
}

int SceneBuilder::texture(Texture texture) {
    m_scene.textures.push_back(std::move(texture));
    return int(m_scene.textures.size()) - 1;
}

SceneBuilder& SceneBuilder::swing(std::size_t count, const glm::dvec3& pivot, const glm::dvec3& axis,
                                  double amplitude_deg, double period_s, double phase) {
    Animation animation;
    animation.type = "swing";
    animation.pivot = pivot;
    animation.axis = glm::normalize(axis);
    animation.amplitude_rad = glm::radians(amplitude_deg);
    animation.period_s = period_s;
    animation.phase = phase;

    // Into the pose at time 0, and with it the joints of what it carries.
    const double start_rad = animation.amplitude_rad * std::sin(2.0 * glm::pi<double>() * phase);
    const glm::dmat4 pose = glm::translate(glm::dmat4(1.0), pivot) *
                            glm::rotate(glm::dmat4(1.0), start_rad, animation.axis) *
                            glm::translate(glm::dmat4(1.0), -pivot);
    const int first = int(m_scene.instances.size() - count);
    for (int i = first; i < int(m_scene.instances.size()); ++i) {
        Instance& instance = m_scene.instances[std::size_t(i)];
        instance.worldFromLocal = pose * instance.worldFromLocal;
        animation.instances.push_back(i);
    }
    for (Animation& carried : m_scene.animations) {
        if (carried.type != "swing" || carried.instances.front() < first) continue;
        carried.pivot = glm::dvec3(pose * glm::dvec4(carried.pivot, 1.0));
        carried.axis = glm::dvec3(pose * glm::dvec4(carried.axis, 0.0));
    }
    m_scene.animations.push_back(std::move(animation));
    return *this;
}

SceneBuilder& SceneBuilder::sun(const std::string& name, const glm::vec3& direction, float intensity_lx) {
    Light light;
    light.name = name;
    light.type = LightType::Sun;
    light.direction = glm::normalize(direction);
    light.intensity = intensity_lx;
    m_scene.lights.push_back(light);
    return *this;
}

SceneBuilder& SceneBuilder::point(const std::string& name, const glm::dvec3& position, float intensity_cd) {
    Light light;
    light.name = name;
    light.type = LightType::Point;
    light.position = position;
    light.intensity = intensity_cd;
    m_scene.lights.push_back(light);
    return *this;
}

SceneBuilder& SceneBuilder::spot(const std::string& name, const glm::dvec3& position, const glm::vec3& direction,
                                 float inner_deg, float outer_deg, float intensity_cd) {
    Light light;
    light.name = name;
    light.type = LightType::Spot;
    light.position = position;
    light.direction = glm::normalize(direction);
    light.inner_rad = glm::radians(inner_deg);
    light.outer_rad = glm::radians(outer_deg);
    light.intensity = intensity_cd;
    m_scene.lights.push_back(light);
    return *this;
}

SceneBuilder& SceneBuilder::camera(const std::string& name, const glm::dvec3& position, const glm::dvec3& target,
                                   float fov_deg) {
    Camera camera;
    camera.name = name;
    camera.position = position;
    camera.target = target;
    camera.fovY_rad = glm::radians(fov_deg);
    m_scene.cameras.push_back(camera);
    return *this;
}

Scene SceneBuilder::finish(float aoRadius_m) {
    m_scene.aoRadius_m = aoRadius_m;
    return std::exchange(m_scene, Scene{});
}

}  // namespace ombrage
