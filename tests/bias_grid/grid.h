// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <ombrage/metrics.h>
#include <ombrage/scene.h>

namespace ombrage::test {

/// The scene scaled about the origin and then moved: the same picture, but for rounding and for lengths that a
/// technique takes for granted. Lights shine as brightly on it, and grow with it.
Scene placed(Scene scene, double scale, const glm::dvec3& shift);

/// The scale that makes the longest side of the scene's bounds `size_m` long.
double scaleTo(const Scene& scene, double size_m);

/// The scene with its first light alone, as another kind of light that shines the same way: a sun along the way from
/// the light to the scene's middle, a lamp on the sun's side, one and a half of the scene's diagonals away. Without a
/// size.
Scene litBy(Scene scene, LightType type);

/// What is varied; every combination is measured.
struct GridAxes {
    std::vector<std::string> techniques{"shadow/map"};  ///< without `resolution` and `format`
    std::vector<int> resolutions{256, 1024, 4096};
    std::vector<std::string> formats{"32f"};
    std::vector<double> sizes_m{0.01, 10, 1000};  ///< longest side of the scene's bounds; 0: as it is
    std::vector<double> shifts_m{0, 5000};        ///< from the origin, along a diagonal
};

/// A scene under one of its lights.
struct GridScene {
    std::string name, light;
    LightType type = LightType::Sun;
    Scene scene;
};

/// The scene's own lights (of more than four only the first), and its first light as the kinds asked for.
std::vector<GridScene> gridScenes(const std::string& name, const std::vector<LightType>& kinds);

struct GridCell {
    std::string scene, light, technique, format;
    int resolution = 0;
    double size_m = 0, shift_m = 0;
    Metrics metrics;
    std::size_t valid = 0;
};

/// Measures every combination of the axes on a scene. @param width, height of the pictures
std::vector<GridCell> measureGrid(const GridScene& scene, const GridAxes& axes, int width, int height);

}  // namespace ombrage::test
