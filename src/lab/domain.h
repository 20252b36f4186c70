// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <ombrage/reference.h>
#include <ombrage/scene.h>
#include <ombrage/technique.h>

namespace ombrage {

/// Why no element of the pipeline may be left out: the reason that one of them cannot render the light, or "".
std::string unsupportedReason(const Pipeline& pipeline, const Light& light);

/// True when a hard technique is given a light with a size: it takes the light's centre.
bool takesCentreOf(const Pipeline& pipeline, const Light& light);

/// What the scene's geometry says about the domains that techniques declare. Computed once per scene.
struct SceneTraits {
    bool closedCasters = true;         ///< every casting model is closed
    bool alphaCasters = false;         ///< a casting mesh has an alpha-tested material
    std::vector<bool> planarTriangle;  ///< per global triangle, whether it lies in one of the scene's large planes
};
SceneTraits sceneTraits(const Scene& scene);

/// Per pixel, whether the declared domain of every element of the pipeline covers it: light size, closed casters and
/// alpha test decide for the whole picture, planar receivers pixel by pixel. Empty: everywhere.
std::vector<bool> domainMask(const Pipeline& pipeline, const Light& light, const SceneTraits& traits,
                             const Receivers& receivers);

}  // namespace ombrage
