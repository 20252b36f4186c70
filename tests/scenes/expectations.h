// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ombrage::test {

/// One line of a scene's expectations: a technique with its parameters, what is measured, and where the figure must
/// lie.
struct Expectation {
    std::string technique;  ///< as `--technique` takes it
    std::string metric;
    std::optional<double> min, max;  ///< exactly one
    std::string why;

    bool meets(std::optional<double> value) const {
        return value && (!min || *value >= *min) && (!max || *value <= *max);
    }
};

/// What a built-in scene declares: the failures that it must show, and the techniques that must not show them.
struct SceneExpectations {
    std::string scene;
    std::string camera, light;  ///< "" the first
    double time_s = 0;
    std::vector<Expectation> shows, holds;
};

/// Size of the pictures that expectations are measured on.
inline constexpr int kExpectationWidth = 320, kExpectationHeight = 180;

/// Reads folder/SCENE.json. @throws Error(Input) for unknown keys, missing ones, or nothing under "shows" or "holds".
SceneExpectations readExpectations(const std::filesystem::path& folder, const std::string& scene);

}  // namespace ombrage::test
