// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <ombrage/tune.h>

namespace ombrage::tuning {

/// The cameras of one scene, by what they are for.
struct Cameras {
    std::vector<std::string> searched, heldOut;
    std::vector<std::string> made;  ///< of the held-out ones: those that were added to the scene
};

/// Least number of held-out cameras where none are named.
inline constexpr std::size_t kFewestHeldOut = 2;

/// Divides the scene's cameras. Those named are held out, where the scene has them, and the others searched on, or
/// `camera` alone where it is named. Where none are held out so, the search sees `camera`, or the first one, and the
/// scene's other ones are held out; up to kFewestHeldOut are made and added to the scene: the searched camera on an
/// orbit about its target, 25 degrees to one side and to the other, nearer where something stands in between.
Cameras divideCameras(Scene& scene, const std::string& camera, const std::vector<std::string>& holdout);

/// A camera turned about its target, around its up, by an angle; by a half, a quarter ... of it while a triangle of the
/// scene lies between the two.
Camera orbited(const Scene& scene, const Camera& camera, double angle_rad);

}  // namespace ombrage::tuning
