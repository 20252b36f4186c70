// SPDX-License-Identifier: MIT
#pragma once

#include <ombrage/scene.h>

namespace ombrage {

/// The camera "main" for a scene without cameras: vertical angle 50 degrees, azimuth 35 (from +z towards +x), elevation
/// 20, the bounding sphere filling 90 % of the height. An interior gets it inside instead: at 20 % of the longest
/// horizontal axis of the bounds, at the height of their centre, looking along that axis.
Camera framedCamera(const Scene& scene);

/// True when nearly all of 64 rays from the centre of the bounds meet a front face first: the inside of a room. (The
/// inside of a solid shows its back faces.)
bool isInterior(const Scene& scene);

/// The light "sun" for a scene without lights: size 0, direction (-1, -2, -0.7), 3 lx.
Light defaultSun();

/// Adds the model "ground": a level square 4 times as wide as the diagonal of the bounds, at their lower side; a thousandth of the diagonal
/// deeper when the scene has a floor of its own there.
void addGround(Scene& scene);

/// Scales lights that together are far brighter than the default sun (files in lux of daylight) down to it, all by one
/// factor, and adds a warning that says so: pictures have no exposure control.
void tameBrightLights(Scene& scene);

}  // namespace ombrage
