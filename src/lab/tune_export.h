// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <ombrage/technique.h>

namespace ombrage::tuning {

/// What a technique's units mean for one light of one scene.
struct LightScale {
    std::string scene, light;
    std::optional<double> texel_m;                     ///< size of a texel; nothing where it grows with the distance
    std::optional<double> width_m, height_m, depth_m;  ///< of an orthographic view
};

/// The values in an engine's own units, as JSON: by light what belongs to a light, each with "value", "exact", and a
/// "note" where it is not exact; and under "without_counterpart" the parameters that the engine has nothing for.
/// @param sceneRadii_m  by scene: what a radius of occlusion of 0 stands for
/// Parameters are known by family, key and unit, so that techniques with the same ones need nothing here.
std::string exportText(const std::string& engine, Family family, const Pipeline& pipeline,
                       const std::vector<LightScale>& lights, const std::map<std::string, double>& sceneRadii_m = {});

}  // namespace ombrage::tuning
