// SPDX-License-Identifier: MIT
#include "lab/spheres.h"

#include <cmath>

#include "scene/mesh_build.h"
#include "scene/shapes.h"

namespace ombrage {

namespace {

constexpr int kSpheresAside = 8;

}  // namespace

Scene spheresScene(std::size_t triangles, int lights) {
    Scene scene;
    scene.name = "spheres";
    scene.materials.emplace_back();
    const auto add = [&](Mesh mesh) {
        makeTangents(mesh);
        const int index = int(scene.meshes.size());
        scene.meshes.push_back(std::move(mesh));
        scene.models.push_back({"model", "", true, true});
        scene.instances.push_back({index, index, glm::dmat4(1.0)});
    };
    add(shapes::floor(24.0f));
    // A sphere of s slices and s / 2 stacks has s (s - 2) triangles.
    const int slices = int(std::ceil(1.0 + std::sqrt(1.0 + double(triangles) / (kSpheresAside * kSpheresAside))));
    for (int i = 0; i < kSpheresAside * kSpheresAside; ++i) {
        const glm::vec2 cell(i % kSpheresAside, i / kSpheresAside);
        const glm::vec2 place = (cell - 0.5f * (kSpheresAside - 1)) * 2.2f;
        add(shapes::sphere({place.x, 1.0f, place.y}, 0.9f, slices, slices / 2));
    }
    for (int i = 0; i < lights; ++i) {
        Light light;
        light.name = "spot " + std::to_string(i);
        light.type = LightType::Spot;
        const double angle = 2.4 * i;  // the golden angle: no two lights shine alike
        light.position = {8 * std::cos(angle), 16.0, 8 * std::sin(angle)};
        light.direction = glm::vec3(glm::normalize(glm::dvec3(0, 1, 0) - light.position));
        light.intensity = 400.0f / float(lights);
        light.inner_rad = 0.7f;
        light.outer_rad = 0.8f;
        scene.lights.push_back(light);
    }
    scene.cameras.emplace_back();
    scene.cameras[0].name = "main";
    scene.cameras[0].position = {9, 9, 16};
    scene.aoRadius_m = 1;
    return scene;
}

}  // namespace ombrage
