// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "techniques/flat_scene_picture.h"

namespace ombrage::test {

/// A light 20 m over a floor, and 9 m over it a sheet without end to the left of x = 0, seen from above between the
/// two: the penumbra of a straight edge, whose closed form is known.
struct HalfPlane {
    static constexpr int kSize_px = 128;  ///< and metres
    static constexpr float kSheet_m = 9, kLight_m = 20, kLightX_m = -10, kRadius_m = 7;

    Scene scene = emptyScene(kSize_px);

    explicit HalfPlane(LightType type) {
        addQuad(scene, {{-99, -99, 0}, {99, -99, 0}, {99, 99, 0}, {-99, 99, 0}}, 0.1f);
        addSheet();
        Light light;
        light.name = "light";
        light.type = type;
        light.position = {kLightX_m, 0, kLight_m};
        light.direction = {0, 0, -1};
        light.inner_rad = light.outer_rad = 1.5f;
        light.radius_m = kRadius_m;
        light.size_m = glm::vec2(2 * kRadius_m);
        if (type == LightType::Sun) {
            light.direction = glm::normalize(glm::vec3(0.9f, 0, -1.0f));
            light.angle_rad = 0.5f;
        }
        scene.lights = {light};
    }

    void addSheet() {
        addQuad(scene, {{-99, -99, kSheet_m}, {0, -99, kSheet_m}, {0, 99, kSheet_m}, {-99, 99, kSheet_m}}, 0.1f);
    }

    /// The row through the light, from the first pixel that shows the floor; pixel i is at x = i + 0.5.
    std::vector<float> row(const std::string& technique) const {
        RenderSettings settings = squareSettings(kSize_px);
        settings.shadow = parsePipeline(Family::Shadow, technique);
        settings.light = "light";
        const RenderResult result = renderFlat(scene, settings);
        const auto plane = result.visibility.begin()->second.plane(0);
        const auto first = plane.begin() + kSize_px / 2 * kSize_px + kSize_px / 2;
        return {first, first + kSize_px / 2};
    }

    /// Of a spot's disk or a square, the share that is seen from x on the floor.
    double visible(double x) const {
        // The edge on the light's plane, in radii from its centre; what lies to the right of it is free.
        const double u =
            std::clamp((x - x * double(kLight_m / kSheet_m) - double(kLightX_m)) / double(kRadius_m), -1.0, 1.0);
        if (scene.lights[0].type == LightType::Rect) return (1 - u) / 2;
        return (std::acos(u) - u * std::sqrt(1 - u * u)) / 3.14159265358979;
    }
};

}  // namespace ombrage::test
