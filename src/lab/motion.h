// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <ombrage/motion.h>
#include <ombrage/scene.h>

namespace ombrage {

/// Instances that a script moves as one.
struct Caster {
    std::string name;  ///< of the model, or of the mesh where the model was too large to move as a whole
    std::vector<int> instances;
};

/// The caster of a name, or the one that is chosen where none is given. Candidates are the models that cast; a model
/// whose bounds are over 60 % of the scene's in diagonal (a whole building) gives its instances in its place, and what
/// is still over 60 % (floors, rooms) is none. Of them the one with the largest bounds is chosen, the first of equals.
/// @throws Error(Usage) for a name that no casting model or mesh has, and where there is no candidate.
Caster chosenCaster(const Scene& scene, const std::string& name);

/// Puts the camera, the light or the caster of `scene` to where the script has it in `frame` (0: as in `start`).
/// `scene` is a copy of `start`, moved by this function or not. A sun climbs: its direction turns in its own vertical
/// plane. Other lights go level, across the way from them to the middle of the bounds. A caster goes level, across the
/// light's direction (or the way from the light to the middle of its bounds).
/// @param light  that is measured; -1 for none: a caster then goes along +X
void poseScene(Scene& scene, const Scene& start, const Motion& motion, int camera, int light, const Caster& caster,
               int frame);

}  // namespace ombrage
