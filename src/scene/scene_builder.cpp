// SPDX-License-Identifier: MIT
#include "scene/scene_builder.h"

#include <utility>

#include <ombrage/image.h>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/mesh_build.h"

namespace ombrage {

SceneBuilder::SceneBuilder(std::string name) {
    m_scene.name = std::move(name);
}

SceneBuilder& SceneBuilder::object(const std::string& name, Mesh mesh, const glm::vec3& color_srgb,
                                   const glm::dvec3& position, double turn_deg) {
    Material material;
    material.name = name;
    for (int i = 0; i < 3; ++i) material.baseColor[i] = linearFromSrgb(color_srgb[i]);
    m_scene.materials.push_back(std::move(material));

    mesh.name = name;
    mesh.material = int(m_scene.materials.size()) - 1;
    makeTangents(mesh);
    m_scene.meshes.push_back(std::move(mesh));
    m_scene.models.push_back({.name = name});

    Instance instance;
    instance.mesh = int(m_scene.meshes.size()) - 1;
    instance.model = int(m_scene.models.size()) - 1;
    instance.worldFromLocal =
        glm::rotate(glm::translate(glm::dmat4(1.0), position), glm::radians(turn_deg), glm::dvec3(0, 1, 0));
    m_scene.instances.push_back(instance);
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
