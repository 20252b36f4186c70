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
Scene penumbrae();
// Occlusion and whole scenes (builtin_occlusion.cpp).
Scene menger();
Scene cornell();
Scene corner();
Scene disk();

// Contacts (builtin_contact.cpp).
Scene thinWall();
Scene resting();
Scene farOrigin();
Scene touching();
Scene headLamp();
// Reach (builtin_reach.cpp).
Scene longView();
Scene lightAhead();
Scene behind();
Scene window();
Scene penumbraRamp();
// Thin and jointed things (builtin_machines.cpp).
Scene bicycle();
Scene figure();
// Holes, hairs and panes (builtin_holes.cpp).
Scene fence();
Scene tree();
Scene fur();
Scene glass();
// Interiors (builtin_interiors.cpp).
Scene bumpy();
Scene nave();
Scene manyLights();
// What programs get wrong (builtin_broken.cpp).
Scene degenerate();
Scene mirrored();
Scene threeCasters();

}  // namespace builtin
}  // namespace ombrage
