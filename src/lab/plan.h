// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <ombrage/compare.h>

namespace ombrage {

/// One render to measure: a pipeline in its family's place and, for shadows, one light.
struct PlannedRun {
    Family family = Family::Shadow;
    Pipeline pipeline;
    int light = -1;  ///< index into Scene::lights; -1 for families that take all lights at once
};

/// The runs of one scene and what was left out of them.
struct ScenePlan {
    std::vector<PlannedRun> runs;  ///< shadows ordered by light
    std::vector<SkippedPair> skipped;
    std::vector<std::string> warnings;  ///< techniques that the scene is not meant for
};

/// Every technique of the family as a pipeline with its defaults, in the order of the registry. A filter follows the
/// family of occlusion's first technique that is not its baseline.
std::vector<std::pair<Family, Pipeline>> pipelinesOf(Family family);

/// @throws Error(Usage) when a pipeline asked for by name does not support a chosen light.
ScenePlan planScene(const Scene& scene, const CompareRequest& request);

/// Ids of the pipeline joined by '+', without parameters.
std::string techniqueText(const Pipeline& pipeline);

}  // namespace ombrage
