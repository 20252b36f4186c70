// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <ombrage/image.h>
#include <ombrage/reference.h>
#include <ombrage/renderer.h>
#include <ombrage/scene.h>

namespace ombrage::test {

/// A model on a floor, to be looked at and lit from anywhere.
struct Stage {
    std::string name;
    Scene scene;             ///< camera 0 and light 0 are replaced
    glm::dvec3 center{0.0};  ///< of the model
    double radius_m = 1;     ///< of the ball around its bounds
    double floor_m = 0;      ///< height of the floor
    bool closed = false;     ///< every mesh of the model is
};

/// @throws Error as loadScene. A built-in scene has its own floor.
Stage makeStage(const std::string& nameOrFile);

/// A view in words.
struct Arrangement {
    std::string camera, light;
};

/// Puts the camera and the light of a seed into the stage's scene, and says which: any kind of light without a
/// size, one in ten within the model's ball, one lamp in four with a range; one camera in eight is orthographic.
Arrangement arrange(Stage& stage, std::uint64_t seed);

struct ViewOutcome {
    std::size_t valid = 0;  ///< pixels that are measured
    double dark = 0;        ///< share of them in shadow
    double wrong = 0;       ///< share of them, as the metric `wrong`
    Image errors;           ///< as errorPicture() has it; empty where nothing is wrong
};

/// Renders what is arranged with each technique and holds it against the truth.
/// @param renderer whose scene is the stage's @param reference of the stage's scene
std::vector<ViewOutcome> measureView(Renderer& renderer, const Reference& reference, const Stage& stage,
                                     const std::vector<std::string>& techniques, int width, int height);

}  // namespace ombrage::test
