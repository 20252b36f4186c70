// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "techniques/flat_scene_picture.h"
#include "techniques/technique_case.h"

namespace ombrage::test {

/// The darkest pixel that a technique of occlusion makes of a plane 60 degrees off the sight that fills the picture.
inline float darkestOfOpenPlane(const std::string& technique, bool orthographic) {
    Scene scene = emptyScene(64);
    const float slope = std::sqrt(3.0f);
    addQuad(scene,
            {{-999, -999, -999 * slope}, {999, -999, -999 * slope}, {999, 999, 999 * slope}, {-999, 999, 999 * slope}},
            0.1f);
    scene.cameras[0].position = {0, 0, 500};
    if (!orthographic) {
        scene.cameras[0].orthoHeight_m.reset();
        scene.cameras[0].fovY_rad = 0.35f;
    }
    RenderSettings settings = squareSettings(64);
    settings.ao = parsePipeline(Family::Ao, technique);
    const std::vector<float> visibility = measuredPlane(renderFlat(scene, settings), Family::Ao);
    return *std::min_element(visibility.begin(), visibility.end());
}

}  // namespace ombrage::test
