// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>

#include <gtest/gtest.h>
#include <ombrage/error.h>
#include <ombrage/renderer.h>

#include "scene/camera_view.h"

namespace ombrage {

/// A test that renders: one renderer with a debug context per test program; any message of OpenGL fails the test.
/// OMBRAGE_DEVICE chooses the device as `--device` does.
class RenderTest : public testing::Test {
protected:
    static RendererOptions options() {
        const char* device = std::getenv("OMBRAGE_DEVICE");
        return {device != nullptr ? device : "", "", true};
    }

    static Renderer& renderer() {
        static const std::unique_ptr<Renderer> shared = std::make_unique<Renderer>(options());
        return *shared;
    }

    /// Renders with the shared renderer. The scene must live until the next call.
    static RenderResult render(const Scene& scene, const RenderSettings& settings) {
        renderer().setScene(scene);
        return again(settings);
    }

    /// Renders the scene of the last call.
    static RenderResult again(const RenderSettings& settings) {
        RenderResult result = renderer().render(settings);
        for (const std::string& message : result.debugMessages) ADD_FAILURE() << "OpenGL says " << message;
        return result;
    }

    /// The sentence of the usage error that these settings give.
    static std::string refusal(const RenderSettings& settings) {
        try {
            renderer().render(settings);
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), ErrorCode::Usage) << e.what();
            return e.what();
        }
        ADD_FAILURE() << "no error";
        return {};
    }
};

/// Scenes put together by hand. A wall is a square of 2 m in the plane z = 0, facing +z, u to +x, the texture's top row
/// at +y.
namespace hand {

inline Mesh wall() {
    Mesh mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.tangents.assign(4, {1, 0, 0, 1});
    mesh.uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

/// A matte material: no highlight.
inline Material matte(const glm::vec3& color) {
    Material material;
    material.baseColor = color;
    material.specular = glm::vec3(0);
    return material;
}

/// Adds a mesh as a model of its own with a material of its own.
inline void add(Scene& scene, Mesh mesh, const Material& material, const glm::dmat4& worldFromLocal = glm::dmat4(1.0)) {
    mesh.material = int(scene.materials.size());
    scene.materials.push_back(material);
    Instance instance;
    instance.mesh = int(scene.meshes.size());
    instance.model = int(scene.models.size());
    instance.worldFromLocal = worldFromLocal;
    scene.meshes.push_back(std::move(mesh));
    scene.models.push_back({"model", "", true, true});
    scene.instances.push_back(instance);
}

/// From the zero along -z, 400 by 200 pixels, the near plane at 1 cm; a view of 90 degrees where no height is given.
inline CameraView viewAhead(std::optional<float> orthoHeight_m = {}) {
    Camera camera;
    camera.position = {0, 0, 0};
    camera.target = {0, 0, -1};
    camera.fovY_rad = 1.5707963f;
    camera.orthoHeight_m = orthoHeight_m;
    // Bounds of more than 100 m: the largest near distance there is.
    CameraView view = makeCameraView(camera, 400, 200, glm::dvec3(0), {glm::dvec3(-100), glm::dvec3(100)});
    EXPECT_FLOAT_EQ(view.near_m, 0.01f);
    return view;
}

inline glm::dmat4 moved(const glm::dvec3& by) {
    glm::dmat4 m(1.0);
    m[3] = glm::dvec4(by, 1);
    return m;
}

inline Camera camera(const glm::dvec3& from, const glm::dvec3& to) {
    Camera made;
    made.name = "main";
    made.position = from;
    made.target = to;
    return made;
}

inline Light sun(const glm::vec3& direction, float intensity_lx) {
    Light light;
    light.name = "sun";
    light.direction = glm::normalize(direction);
    light.intensity = intensity_lx;
    return light;
}

inline Light at(LightType type, const glm::dvec3& position, const glm::vec3& direction, float intensity) {
    Light light;
    light.name = lightTypeName(type);
    light.type = type;
    light.position = position;
    light.direction = glm::normalize(direction);
    light.intensity = intensity;
    return light;
}

/// One wall seen from 2 m in front of it, filling the picture's height of 1.6 m orthographically, under a sun that
/// shines straight at it.
inline Scene wallScene(const Material& material = matte({0.5f, 0.25f, 0.125f})) {
    Scene scene;
    add(scene, wall(), material);
    scene.lights = {sun({0, 0, -1}, 3)};
    scene.cameras = {camera({0, 0, 2}, {0, 0, 0})};
    scene.cameras[0].orthoHeight_m = 1.6f;
    scene.ambient = 0;
    return scene;
}

}  // namespace hand
}  // namespace ombrage
