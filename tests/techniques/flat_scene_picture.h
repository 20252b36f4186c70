// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <ombrage/renderer.h>
#include <ombrage/scene.h>

namespace ombrage::test {

/// No objects, no surroundings' light; an orthographic camera that looks along -z at the origin from z = 10, so that
/// one metre is one pixel of a square picture of `size_px`.
inline Scene emptyScene(int size_px) {
    Scene scene;
    scene.name = "flat";
    scene.ambient = 0;
    scene.aoRadius_m = 8;
    Camera camera;
    camera.name = "main";
    camera.position = {0, 0, 10};
    camera.target = {0, 0, 0};
    camera.orthoHeight_m = float(size_px);
    scene.cameras.push_back(camera);
    Light dark;
    dark.name = "dark";
    dark.direction = {0, 0, -1};
    dark.intensity = 0;
    scene.lights.push_back(dark);
    return scene;
}

/// Adds a quad of four corners, counter-clockwise seen from its front, that emits a grey and reflects nothing.
inline void addQuad(Scene& scene, const std::vector<glm::vec3>& corners, float emitted) {
    const int index = int(scene.meshes.size());
    Material material;
    material.baseColor = material.specular = glm::vec3(0);
    material.emissive = glm::vec3(emitted);
    scene.materials.push_back(material);
    const glm::vec3 side = glm::normalize(corners[1] - corners[0]);
    const glm::vec3 normal = glm::normalize(glm::cross(side, corners[2] - corners[0]));
    Mesh mesh;
    mesh.positions = corners;
    mesh.normals.assign(4, normal);
    mesh.tangents.assign(4, glm::vec4(side, 1));
    mesh.uvs.assign(4, glm::vec2(0));
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.material = index;
    scene.meshes.push_back(mesh);
    Model model;
    model.name = "quad";
    scene.models.push_back(model);
    Instance instance;
    instance.mesh = instance.model = index;
    scene.instances.push_back(instance);
}

inline RenderSettings squareSettings(int size_px) {
    RenderSettings settings;
    settings.width = settings.height = size_px;
    return settings;
}

/// Renders with a debug context; any of its messages fails the test. One renderer for the whole program.
RenderResult renderFlat(const Scene& scene, const RenderSettings& settings);

}  // namespace ombrage::test
