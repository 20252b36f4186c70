// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>

#include "techniques/flat_scene_picture.h"

namespace ombrage::test {

// A wall of 32 x 32 m in z = 0, seen straight on: a metre is a pixel. A lamp 4 m before it throws the shadow of what is
// at height z to 4 / (4 - z) times its place.
inline constexpr int kSize = 32;

inline Scene wallAndLamp() {
    Scene scene = emptyScene(kSize);
    addQuad(scene, {{-16, -16, 0}, {16, -16, 0}, {16, 16, 0}, {-16, 16, 0}}, 0.5f);
    scene.lights[0].type = LightType::Point;
    scene.lights[0].position = {0, 0, 4};
    scene.lights[0].intensity = 100;
    return scene;
}

/// x from 1 to 2, y from -1 to 1; its height goes from `near_m` at x = 1 to `far_m` at x = 2.
inline void addCaster(Scene& scene, float near_m, float far_m) {
    addQuad(scene, {{1, -1, near_m}, {2, -1, far_m}, {2, 1, far_m}, {1, 1, near_m}}, 0.2f);
}

class Wall {
public:
    explicit Wall(const Scene& scene, const std::string& technique = "shadow/planar",
                  Composite composite = Composite::Lighting) {
        RenderSettings settings = squareSettings(kSize);
        settings.shadow = parsePipeline(Family::Shadow, technique);
        settings.composite = composite;
        m_result = renderFlat(scene, settings);
    }
    /// At the pixel that holds the point of the wall.
    float at(float x, float y) const { return m_result.visibility.begin()->second.plane(0)[pixel(x, y)]; }
    glm::vec3 colorAt(float x, float y) const {
        glm::vec3 color;
        for (int c = 0; c < 3; ++c) color[c] = m_result.picture.plane(c)[pixel(x, y)];
        return color;
    }
    int countBelow(float bound) const {
        const auto plane = m_result.visibility.begin()->second.plane(0);
        return int(std::count_if(plane.begin(), plane.end(), [&](float v) { return v < bound; }));
    }
    bool ran(const std::string& pass) const {
        return std::any_of(m_result.passes.begin(), m_result.passes.end(),
                           [&](const PassCost& cost) { return cost.name == pass; });
    }
    const RenderResult& result() const { return m_result; }

private:
    static std::size_t pixel(float x, float y) { return std::size_t((16 - y) * 1.0f) * kSize + std::size_t(x + 16); }
    RenderResult m_result;
};

/// Lamp and casters behind the camera, so that they hide nothing of the wall: at half the lamp's height everything is
/// thrown to twice its place, too.
inline Scene wallAndFarLamp() {
    Scene scene = wallAndLamp();
    scene.lights[0].position = {0, 0, 40};
    scene.lights[0].intensity = 1e4f;
    return scene;
}

inline void addFarCaster(Scene& scene, float left, float right, float bottom, float top) {
    addQuad(scene, {{left, bottom, 20}, {right, bottom, 20}, {right, top, 20}, {left, top, 20}}, 0.2f);
}

}  // namespace ombrage::test
