// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <ombrage/scene.h>

namespace ombrage {

/// A built-in scene by name. @throws Error(Usage) with a suggestion for an unknown name.
Scene makeBuiltinScene(const std::string& name);

namespace builtin {

// Bias and map precision (builtin_bias.cpp).
Scene planeGrazing();
Scene gap();
Scene sphere();
Scene comb();
// Volumes and leaks (builtin_volumes.cpp).
Scene inShadow();
Scene twoCasters();
Scene room();
Scene openMesh();
Scene areaOverlap();
// Occlusion and whole scenes (builtin_occlusion.cpp).
Scene menger();
Scene cornell();
Scene corner();
Scene disk();

}  // namespace builtin
}  // namespace ombrage
