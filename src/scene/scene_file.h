// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include <ombrage/scene.h>

#include "scene/model_file.h"

namespace ombrage {

/// Moves what a model file holds into the scene as one model. Lights and cameras are left to the caller.
void addModel(Scene& scene, ModelFile&& file, Model model, const glm::dmat4& worldFromFile);

/// Adds the default sun if there are no lights and sets the default radius of occlusion if there is none (0). Call
/// before a ground is added.
void completeScene(Scene& scene);

/// Reads a scene file. @throws Error(Input) whose where() is "FILE:LINE: /json/pointer".
Scene readSceneFile(const std::filesystem::path& file, const SceneOptions& options);

}  // namespace ombrage
